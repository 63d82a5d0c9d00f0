#pragma once

#include <functional>
#include <optional>
#include <string>

namespace clevis::cad {

/// A length that would fit if its unit were another one.
struct UnitSlip {
  double factor{};    ///< that it would have to be multiplied by
  std::string units;  ///< "an inch is 25.4 mm"
};

/// Tries whether a length is off by 1000 or 25.4, as wrong units make it.
/// @param fits  whether the length fits once it is multiplied by this factor.
std::optional<UnitSlip> unit_slip(const std::function<bool(double)>& fits);

}  // namespace clevis::cad
