#pragma once

#include "mechanism/definition/definition.h"
#include "scene/text/names.h"
#include "scene/text/strict_table.h"

namespace clevis::scene {

/// Adds the [[initial]] tables to a mechanism that has its joints.
void read_initial_states(StrictTable& root, Names& names,
                         mechanism::MechanismDefinition& mechanism);

}  // namespace clevis::scene
