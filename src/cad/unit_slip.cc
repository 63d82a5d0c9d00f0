#include "cad/unit_slip.h"

#include <array>
#include <utility>

namespace clevis::cad {

std::optional<UnitSlip> unit_slip(const std::function<bool(double)>& fits) {
  constexpr std::array<std::pair<double, const char*>, 2> kRatios{
      {{1000.0, "a metre is 1000 mm"}, {25.4, "an inch is 25.4 mm"}}};
  for (const auto& [ratio, units] : kRatios) {
    for (const double factor : {ratio, 1.0 / ratio}) {
      if (fits(factor)) return UnitSlip{factor, units};
    }
  }
  return std::nullopt;
}

}  // namespace clevis::cad
