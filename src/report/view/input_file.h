#pragma once

#include <filesystem>
#include <string>

namespace clevis::report {

/// The bytes of a file.
/// @throws Error I001.
std::string file_text(const std::filesystem::path& file);

/// "2026-11-23T04:48:36Z": when the file was changed last, in UTC.
/// @throws Error I001.
std::string modified_at(const std::filesystem::path& file);

}  // namespace clevis::report
