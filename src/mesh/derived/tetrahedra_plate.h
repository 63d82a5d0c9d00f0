#pragma once

#include <optional>

#include "mesh/cells/part_mesh.h"

namespace clevis::mesh {

/// plate_mid_plane of a mesh of tetrahedra.
std::optional<PartMesh<2>> tetrahedra_mid_plane(const PartMesh<3>& mesh);

}  // namespace clevis::mesh
