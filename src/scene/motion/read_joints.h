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

}  // namespace clevis::scene
