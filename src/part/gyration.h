#pragma once

#include <algorithm>
#include <cmath>

#include "part/mass_properties.h"

namespace clevis::part {

/// Root of the mean square distance of a body's mass from its centre [m]; 0 of
/// points and of bodies without mass. At least its largest radius of gyration.
inline double radius_of_mass(const MassProperties& given) {
  if (!(given.mass > 0.0)) return 0.0;
  return std::sqrt(std::max(0.0, 0.5 * given.inertia_LCm.trace()) / given.mass);
}

}  // namespace clevis::part
