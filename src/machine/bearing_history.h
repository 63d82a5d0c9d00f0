#pragma once

#include <vector>

#include "machine/bearing.h"
#include "mechanism/definition.h"
#include "mechanism/motion.h"

namespace clevis::machine {

/// Whether a joint turns about one axis that bearings can sit on: revolute or
/// cylindrical.
bool takes_bearing(mechanism::JointType type);

/// Load and speed of a bearing over a motion and at its change points: the
/// reaction of its joint along and across the joint's axis on body a, the
/// moment across it, and how fast b turns against a about it.
/// @pre takes_bearing() of the joint.
std::vector<BearingInstant> bearing_history(
    const BearingDefinition& bearing,
    const mechanism::MechanismDefinition& mechanism,
    const mechanism::Motion& motion);

}  // namespace clevis::machine
