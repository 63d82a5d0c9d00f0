#pragma once

#include <vector>

#include "mechanism/definition/definition.h"
#include "scene/text/names.h"
#include "scene/text/strict_table.h"

namespace clevis::scene {

/// The [[drive]] tables of joints. @throws Error S002–S011.
std::vector<mechanism::BodyDefinition> read_bodies(StrictTable& root,
                                                   Names& names);
std::vector<mechanism::JointDefinition> read_joints(
    StrictTable& root, const std::vector<mechanism::BodyDefinition>& bodies,
    Names& names);
std::vector<mechanism::CouplingDefinition> read_couplings(
    StrictTable& root, const std::vector<mechanism::JointDefinition>& joints,
    Names& names);
std::vector<mechanism::DriveDefinition> read_drives(
    StrictTable& root, const std::vector<mechanism::JointDefinition>& joints,
    Names& names);

/// The law that a coordinate follows, of a drive or a servo: `law` and its
/// keys.
void read_drive_law(StrictTable& table, Dimension coordinate,
                    mechanism::DriveDefinition& drive);

}  // namespace clevis::scene
