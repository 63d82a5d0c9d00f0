#pragma once

#include <vector>

#include "mechanism/definition/definition.h"
#include "scene/text/names.h"
#include "scene/text/strict_table.h"

namespace clevis::scene {

/// The [[joint]] tables between bodies. @throws Error S002–S011.
std::vector<mechanism::BodyDefinition> read_bodies(StrictTable& root,
                                                   Names& names);
std::vector<mechanism::JointDefinition> read_joints(
    StrictTable& root, const std::vector<mechanism::BodyDefinition>& bodies,
    Names& names);

/// Columns: x along the normal as far as it is orthogonal to the axis, y, z
/// along the axis. @throws Error S006 if they are parallel.
Eigen::Matrix3d joint_rotation(const Eigen::Vector3d& axis,
                               const Eigen::Vector3d& normal,
                               const Value& where);

}  // namespace clevis::scene
