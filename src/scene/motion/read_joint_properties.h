#pragma once

#include <vector>

#include "mechanism/definition/definition.h"
#include "scene/text/names.h"
#include "scene/text/strict_table.h"

namespace clevis::scene {

/// The origins and axes of a joint apart, what its type needs besides: lead,
/// length, compliance.
void read_joint_properties(StrictTable& table,
                           const std::vector<mechanism::BodyDefinition>& bodies,
                           mechanism::JointDefinition& joint);

/// Index of the coordinate that `value` names. @throws Error S009.
int find_coordinate(const Value& value,
                    const mechanism::JointDefinition& joint);

/// The [[coupling]] tables. @throws Error S002–S011.
std::vector<mechanism::BodyDefinition> read_bodies(StrictTable& root,
                                                   Names& names);
std::vector<mechanism::JointDefinition> read_joints(
    StrictTable& root, const std::vector<mechanism::BodyDefinition>& bodies,
    Names& names);
std::vector<mechanism::CouplingDefinition> read_couplings(
    StrictTable& root, const std::vector<mechanism::JointDefinition>& joints,
    Names& names);

}  // namespace clevis::scene
