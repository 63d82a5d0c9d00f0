#pragma once

#include <vector>

#include "machine/bearings/bearing.h"
#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"

namespace clevis::machine {

/// Load and speed of a bearing over a motion and at its change points: the
/// reaction of its joint along and across the joint's axis on body a, the
/// moment across it, and how fast b turns against a about it.
/// @pre the joint takes bearings (JointTraits).
std::vector<BearingInstant> bearing_history(
    const BearingDefinition& bearing,
    const mechanism::MechanismDefinition& mechanism,
    const mechanism::Motion& motion);

}  // namespace clevis::machine
