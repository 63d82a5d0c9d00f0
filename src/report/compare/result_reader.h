#pragma once

#include <filesystem>

#include "report/compare/stored_result.h"

namespace clevis::report {

/// Reads a result.json or a transmission.json, or the former in a folder.
/// Seconds, sizes of the systems and self-checks stay out: they say how, not
/// what. Unknown keys are left alone, so that a baseline outlives additions to
/// the format.
/// @throws Error I001, I003 (with line and column, or with the key), R002 if
///   the schema is another one.
StoredResult read_result(const std::filesystem::path& file_or_folder);

}  // namespace clevis::report
