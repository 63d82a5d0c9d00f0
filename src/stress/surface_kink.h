#pragma once

#include <vector>

#include "mesh/part_mesh.h"

namespace clevis::stress {

/// Largest angle between the surfaces of neighbouring faces of the boundary
/// along their common edge, where it is below 20° everywhere [rad]: what the
/// mesh makes of a curved surface that it does not follow exactly. Others are
/// edges of the part.
/// @param cells  whose edges are looked at.
double largest_kink(const mesh::PartMesh<3>& mesh,
                    const std::vector<int>& cells);

}  // namespace clevis::stress
