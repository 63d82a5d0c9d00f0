#pragma once

#include <filesystem>

#include "app/request/options.h"

namespace clevis::app {

/// Where `check` writes: --out, else results/<folder> for the scene.toml of a
/// folder, results/<folder>_<scene> for any other scene.
std::filesystem::path output_folder(const Options& options);

/// Removes what an earlier check left in its output folder, as its result.json
/// tells: so that the files there are always of one run. Does nothing in a
/// folder without a result.json.
void remove_previous_run(const std::filesystem::path& folder);

}  // namespace clevis::app
