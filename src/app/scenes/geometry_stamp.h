#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "part/geometry_input.h"
#include "part/part_definition.h"

namespace clevis::app {

/// The mark by which a mesh says from which geometry it was made: the
/// fingerprint of geometry_content() and of what the part gives to it:
/// parameters, faces of joints and selectors, sizes. It guards against
/// forgetting, not against forgery.
std::string geometry_stamp(const part::PartDefinition& part,
                           const part::GeometryInput& input = {});

/// Whether the part's mesh is there and bears the stamp of its geometry.
bool has_current_mesh(const part::PartDefinition& part,
                      const part::GeometryInput& input);

/// The .msh with the stamp as a $Comments section behind $MeshFormat, which
/// gmsh and clevis skip.
/// @pre `mesh` holds the section $MeshFormat.
std::string stamped(std::string mesh, std::string_view stamp);

/// The stamp of a .msh file; nothing if it has none or cannot be read.
std::optional<std::string> stamp_of(const std::filesystem::path& mesh);

/// Refuses a stamped mesh whose geometry, or a file that it reads, has changed
/// since, and a mesh of parameters that has not been made. A mesh without
/// stamp and a part without geometry are the user's own affair.
/// @throws Error M011.
void require_current_mesh(const part::PartDefinition& part,
                          const part::GeometryInput& input = {});

}  // namespace clevis::app
