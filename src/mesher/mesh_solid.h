#pragma once

#include <TopoDS_Solid.hxx>

#include "cad/exchange.h"
#include "cad/face.h"

namespace clevis::mesher {

/// Meshes a solid with curved tetrahedra of order 2 by gmsh, or a plate with
/// one layer of hexahedra of order 2 over quadrangles, and writes a .msh
/// (4.1) in millimetres, whose physical groups are those asked for and the
/// volume.
/// @throws Error M010 with what gmsh says.
void mesh_solid(const TopoDS_Solid& solid, const cad::Solid& described,
                const cad::Request& request);

}  // namespace clevis::mesher
