#pragma once

#include <optional>

#include "mesh/cells/part_mesh.h"

namespace clevis::mesh {

/// The mid-plane of a mesh that is (to 1e-8 of its size) a plate extruded along
/// z with uniform thickness: same quads in every layer, straight normal edges.
/// Its groups are those that lie on the sides only, in the same order; a group
/// on top or bottom is left out. Nothing if the part is not such a plate.
///
/// Tetrahedra need no layers: where every face of the outside lies at the
/// bottom, at the top or upright between them, the triangles at the bottom are
/// the mid-plane's, and groups on the sides reach from bottom to top.
std::optional<PartMesh<2>> plate_mid_plane(const PartMesh<3>& mesh);

}  // namespace clevis::mesh
