#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "mesh/gmsh/gmsh_file.h"

namespace clevis::mesh {

/// Reads gmsh 2.2 and 4.1, ASCII and little-endian binary.
///
/// Nothing but numbers is interpreted, and no count is believed that the
/// rest of the file cannot hold.
/// @throws Error M001 if it is no such file, M002 if it is damaged, M004 for
///   a coordinate that is not finite, M008 for unknown elements, I001.
GmshFile read_gmsh_file(const std::filesystem::path& path);

/// The same from bytes that were read already.
GmshFile parse_gmsh(std::string_view bytes, const std::string& name);

}  // namespace clevis::mesh
