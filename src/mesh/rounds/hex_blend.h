#pragma once

#include "mesh/cells/part_mesh.h"
#include "mesh/rounds/cylindrical_entities.h"

namespace clevis::mesh {

/// Moves the points of the cells that touch a cylinder: corners to their
/// vertices, edges along round_edge, faces onto their cylinder; every other
/// edge, face and interior follows by transfinite blending, so that
/// neighbours still share their points.
/// @param file_order  of the geometry in the file.
void blend_hexahedra(PartMesh<3>& mesh, const CylindricalEntities& round,
                     int file_order);

}  // namespace clevis::mesh
