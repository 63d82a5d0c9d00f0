#include "assessment/judge/finite_motion.h"

#include <algorithm>
#include <numbers>

#include <fmt/format.h>

namespace clevis::assessment {

double reach(const FiniteMotion& motion) {
  return std::max(motion.rotation / kLargestRotation,
                  motion.strain / kLargestStrain);
}

FiniteMotion farther(const FiniteMotion& one, const FiniteMotion& other) {
  FiniteMotion result = reach(one) < reach(other) ? other : one;
  result.rotation = std::max(one.rotation, other.rotation);
  result.strain = std::max(one.strain, other.strain);
  return result;
}

std::string beyond_small_displacements(const FiniteMotion& motion) {
  std::string what;
  if (motion.rotation > kLargestRotation) {
    what = fmt::format("the part turns by {:.3g}° within itself",
                       motion.rotation * 180.0 / std::numbers::pi);
  } else if (motion.strain > kLargestStrain) {
    what = fmt::format("the part strains by {:.3g} %", 100.0 * motion.strain);
  } else {
    return "";
  }
  return fmt::format(
      "{} ({}): small displacements no longer hold (5°, 5 %), the numbers of "
      "linear elasticity are not those of the part. Make it stiffer, or "
      "compute "
      "it with large displacements elsewhere",
      what, motion.label);
}

}  // namespace clevis::assessment
