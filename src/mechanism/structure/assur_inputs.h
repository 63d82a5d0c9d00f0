#pragma once

#include <vector>

#include "mechanism/definition/definition.h"

namespace clevis::mechanism {

/// Joints taken as inputs of a planar mechanism beside its drives, as
/// textbooks do, so that the rest can be split into groups: those on which a
/// motor, servo, gas cylinder or a force over time acts, then those on ground,
/// then others, each in the order of the definition.
/// @param count  how many freedoms the drives leave.
/// @return  joints; fewer than `count` if they cannot lead all that moves.
/// @pre  revolutes, slides and welds only.
std::vector<int> assumed_inputs(const MechanismDefinition& definition,
                                int count);

}  // namespace clevis::mechanism
