#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "part/part_definition.h"

namespace clevis::app {

/// The mark by which a mesh says from which geometry it was made: the 64-bit
/// FNV-1a hash of geometry_content(), 16 hexadecimal digits. It guards against
/// forgetting, not against forgery.
std::string geometry_stamp(std::string_view geometry);

/// The .msh with the stamp as a $Comments section behind $MeshFormat, which
/// gmsh and clevis skip.
/// @pre `mesh` holds the section $MeshFormat.
std::string stamped(std::string mesh, std::string_view stamp);

/// The stamp of a .msh file; nothing if it has none or cannot be read.
std::optional<std::string> stamp_of(const std::filesystem::path& mesh);

/// Refuses a stamped mesh whose .geo, or a file that it reads, has changed
/// since. A mesh without stamp
/// and a part without geometry are the user's own affair.
/// @throws Error M011.
void require_current_mesh(const part::PartDefinition& part);

}  // namespace clevis::app
