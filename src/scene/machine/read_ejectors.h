#pragma once

#include <vector>

#include "machine/devices/ejector.h"
#include "part/part_definition.h"
#include "scene/text/names.h"
#include "scene/text/strict_table.h"

namespace clevis::scene {

/// The [[ejector]] tables, which need no mechanism.
std::vector<machine::EjectorDefinition> read_ejectors(
    StrictTable& root, const std::vector<part::Material>& materials,
    Names& names);

}  // namespace clevis::scene
