#pragma once

#include <string>
#include <vector>

#include "cad/exchange.h"
#include "cad/face.h"
#include "mesh/cells/part_mesh.h"
#include "part/part_definition.h"
#include "part/solid_source.h"

namespace clevis::app {

/// The mesh of a part that is a solid.
struct SolidMesh {
  std::string text;               ///< .msh in millimetres
  mesh::PartMesh<3> mesh;         ///< the same, as `check` reads it
  std::vector<std::string> told;  ///< unit, faces of joints
};

/// A line of what a CAD file holds: its unit, size, volume, faces.
std::string about(const cad::Solid& solid);

/// Finds the faces of a part's joints and selectors and meshes it; each other
/// cylinder becomes a group round_N. Where curved cells fold, finer ones
/// follow.
/// @throws Error M….
SolidMesh mesh_solid_part(const part::PartDefinition& part,
                          const part::SolidSource& source,
                          const cad::Refinement& finer = {});

}  // namespace clevis::app
