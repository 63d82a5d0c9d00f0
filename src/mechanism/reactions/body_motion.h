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

/// Components of all reactions along the axes of J as they are given; those of
/// a planar mechanism are solved for along others (align_joint_frames()).
void refer_to_given_frames(const MechanismDefinition& definition,
                           Motion& motion);

}  // namespace clevis::mechanism
