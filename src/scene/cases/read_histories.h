#pragma once

#include <filesystem>
#include <vector>

#include "part/load_series.h"
#include "scene/text/strict_table.h"

namespace clevis::scene {

/// The [[part.history]] tables of a part, with the files that they name.
/// @param file  of the scene: paths are relative to its folder.
/// @throws Error S002–S012, I001.
std::vector<part::LoadSeries> read_histories(StrictTable& part,
                                             const std::filesystem::path& file);

}  // namespace clevis::scene
