#pragma once

#include <vector>

#include "mechanism/constraints/constraint_system.h"
#include "mechanism/definition/motion.h"
#include "mechanism/forces/force_model.h"

namespace clevis::mechanism {

/// Friction that holds its line is a reaction like a joint's: marks which of
/// these, and which components of joints and couplings, equilibrium leaves open
/// because lines at rest hold the same freedom. How they share it depends on
/// how they came to rest.
/// @param instant  with its joints, couplings and elements.
void mark_what_friction_leaves_open(const SolvingFrame& frame,
                                    const ConstraintSystem& system,
                                    const std::vector<PlacedJoint>& placed,
                                    const ForceModel& forces,
                                    const ForceState& acting, Instant& instant);

}  // namespace clevis::mechanism
