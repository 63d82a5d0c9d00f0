#pragma once

#include <filesystem>
#include <vector>

#include "part/geometry_input.h"
#include "part/part_definition.h"
#include "scene/text/names.h"
#include "scene/text/strict_table.h"

namespace clevis::scene {

/// A part, and what it gives to its geometry.
struct PartOfGeometry {
  part::PartDefinition part;
  part::GeometryInput input;
};

/// A part without its seats, which need the mechanism.
/// @param file  the scene's, which the part's paths are relative to.
PartOfGeometry read_part(StrictTable& table, const Names& names,
                         const std::vector<part::Material>& materials,
                         const std::filesystem::path& file);

}  // namespace clevis::scene
