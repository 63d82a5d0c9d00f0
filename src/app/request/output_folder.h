#pragma once

#include <filesystem>

#include "app/request/options.h"

namespace clevis::app {

/// Where `check` writes: --out, else results_folder().
std::filesystem::path output_folder(const Options& options);

/// results/<folder> for the scene.toml of a folder, results/<folder>_<scene>
/// for any other scene.
std::filesystem::path results_folder(const std::filesystem::path& scene_file);

/// What becomes of a report.html while the next check runs.
enum class OldReport { kRemove, kKeep };

/// Removes what an earlier check left in its output folder, as its result.json
/// tells: so that the files there are always of one run. In a folder without a
/// result.json, at most an error.json.
void remove_previous_run(const std::filesystem::path& folder, OldReport report);

/// Says on stderr where a report was written.
void tell_report(const std::filesystem::path& file);

}  // namespace clevis::app
