#pragma once

#include <vector>

#include "machine/bearings/bearing.h"
#include "mechanism/joints/joint_types.h"
#include "scene/text/names.h"
#include "scene/text/strict_table.h"

namespace clevis::scene {

/// The [[bearing]] tables; a joint that turns about one axis each.
std::vector<machine::BearingDefinition> read_bearings(
    StrictTable& root, const std::vector<mechanism::JointDefinition>& joints,
    Names& names);

}  // namespace clevis::scene
