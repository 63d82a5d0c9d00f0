#pragma once

#include <filesystem>
#include <string>

namespace clevis::app {

/// The bytes of a .geo and, behind them, of all files that it reads: those of
/// Merge, Include and ShapeFromFile with a name in quotes, of included .geo
/// files likewise; names are relative to the file that has them. Files that
/// are not there add nothing; names that gmsh would have to compute are not
/// followed.
std::string geometry_content(const std::filesystem::path& geometry);

}  // namespace clevis::app
