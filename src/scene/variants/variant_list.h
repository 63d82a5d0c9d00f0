#pragma once

#include <filesystem>
#include <vector>

#include "scene/variants/design.h"

namespace clevis::scene {

/// The variants of a CSV file, one per row. Its header names the paths, each
/// with the unit of its column in square brackets behind a space
/// ("part.AB.thickness [mm]"), or without one where the fields are whole
/// values ("8 mm", steel_45). A column `variant` has their names, else they
/// are v001, v002 …
/// @throws Error I001, S012 if it is no such table, S006 and S008 if a name
///   cannot be that of a folder or stands twice, S007 if a path is none.
std::vector<Variant> read_variant_list(const std::filesystem::path& file);

}  // namespace clevis::scene
