#pragma once

#include "mechanism/constraints/constraint_system.h"
#include "mechanism/definition/motion.h"
#include "mechanism/reactions/equilibrium.h"

namespace clevis::mechanism {

/// State of a body's frame L in W, from that of its reference point M in the
/// solving frame.
BodyState body_motion(const SolvingFrame& frame, BodyIndex body,
                      const BodyPlacement& placement, const Twist& twist,
                      const SpatialAcceleration& acceleration);

/// Moves reactions, efforts of drives and couplings, expressed in P, into the
/// instant, where they are expressed in W; its drives are there already.
void put_forces(const SolvingFrame& frame, const ConstraintSystem& system,
                const std::vector<PlacedJoint>& placed,
                Equilibrium::Solution forces, Instant& instant);

}  // namespace clevis::mechanism
