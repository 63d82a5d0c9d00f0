#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace clevis::app {

/// A .geo and all files that it reads: those of Merge, Include and
/// ShapeFromFile with a name in quotes, of included .geo files likewise, each
/// once, whether they are there or not; names are relative to the file that
/// has them. Names that gmsh would have to compute are not followed.
std::vector<std::filesystem::path> geometry_files(
    const std::filesystem::path& geometry);

/// The bytes of geometry_files(), one after another. Files that are not there
/// add nothing.
std::string geometry_content(const std::filesystem::path& geometry);

}  // namespace clevis::app
