#pragma once

#include <string>

#include "mesh/reading/mesh_reader.h"
#include "part/part_definition.h"

namespace clevis::app {

/// The mesh that the text of a .msh holds, through the same validation as in
/// `check`: what does not pass is not kept.
/// @throws Error M….
mesh::ReadMesh validated_mesh(const std::string& text,
                              const part::PartDefinition& part);

}  // namespace clevis::app
