#pragma once

#include "mesh/cells/part_mesh.h"

namespace clevis::mesh {

/// Turns each hexahedron (keeping its handedness) so that parallel edges
/// agree in direction over the whole mesh. Leaves a mesh as it is in which
/// that cannot be.
void orient_consistently(PartMesh<3>& mesh);

}  // namespace clevis::mesh
