#pragma once

#include <algorithm>

#include "part/part_definition.h"

namespace clevis::part {

/// The buckling factor that a part must have: of its limits, else 1.5, or their
/// safety factor if that is higher [1].
inline double wanted_buckling_factor(const Limits& limits) {
  constexpr double kDefault = 1.5;
  return limits.buckling.value_or(
      std::max(kDefault, limits.safety_factor.value_or(kDefault)));
}

}  // namespace clevis::part
