#include "report/parts/limit_quantities.h"

#include <string>

namespace clevis::report {
namespace {

constexpr Rule kLimitRule =
    exact("a limit that is loosened makes a part pass that did not");

}  // namespace

const Quantities<part::Limits>& limit_quantities() {
  using S = part::Limits;
  static const Quantities<S> rows = {
      quantity<S>(
          {"limit_safety_factor", "/safety_factor", "1", "", kLimitRule},
          &S::safety_factor),
      quantity<S>({"limit_deflection", "/deflection_mm", "mm", "", kLimitRule},
                  &S::deflection),
      quantity<S>({"limit_buckling", "/buckling", "1", "", kLimitRule},
                  &S::buckling),
      quantity<S>(
          {"limit_singular_zones", "/singular_zones", "", "", kLimitRule},
          [](const S& limits) {
            return std::string(limits.exclude_singular_zones ? "exclude"
                                                             : "count");
          }),
  };
  return rows;
}

}  // namespace clevis::report
