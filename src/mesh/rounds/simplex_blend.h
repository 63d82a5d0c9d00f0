#pragma once

#include "mesh/cells/part_mesh.h"
#include "mesh/rounds/cylindrical_entities.h"

namespace clevis::mesh {

/// blend_hexahedra() for tetrahedra of degree 4 at most: what an edge or a face
/// moves fades with the barycentric coordinates of its own vertices.
void blend_tetrahedra(PartMesh<3>& mesh, const CylindricalEntities& round,
                      int file_order);

}  // namespace clevis::mesh
