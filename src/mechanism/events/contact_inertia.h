#pragma once

#include <cstddef>

#include "mechanism/equations_of_motion/equations_of_motion.h"

namespace clevis::mechanism {

/// Effective masses of two bodies at their contact along its normal, joints and
/// drives holding [kg] or [kg m²]; infinite where they cannot give way.
struct ContactInertia {
  double mass_a{}, mass_b{}, mass{};
  double force{};  ///< of all else that presses them together [N] or [N m]
};

/// Acceleration apart of the bodies at a contact or an end of a stop, as of the
/// last solve() [m/s²] or [rad/s²].
double opening_acceleration(EquationsOfMotion& equations, std::size_t element,
                            int end);
/// Of a contact or an end of a stop, as of the last solve().
ContactInertia contact_inertia(EquationsOfMotion& equations,
                               std::size_t element, int end);

}  // namespace clevis::mechanism
