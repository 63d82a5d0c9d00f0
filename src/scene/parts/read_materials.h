#pragma once

#include <vector>

#include "part/part_definition.h"
#include "scene/text/names.h"
#include "scene/text/strict_table.h"

namespace clevis::scene {

/// The [material] tables. @throws Error S002–S011.
std::vector<part::Material> read_materials(StrictTable& root, Names& names);

}  // namespace clevis::scene
