#pragma once

#include "mechanism/definition/definition.h"
#include "scene/text/names.h"
#include "scene/text/strict_table.h"

namespace clevis::scene {

/// The element of a [[force]] table, by its `type`. @throws Error S002–S011.
mechanism::ForceElement read_element(
    const std::string& name, StrictTable& table,
    const std::vector<mechanism::JointDefinition>& joints, const Names& names);

}  // namespace clevis::scene
