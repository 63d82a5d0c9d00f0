#pragma once

#include "mesh/cells/part_mesh.h"

namespace clevis::mesh {

/// Each hexahedron cut into n³ along its own coordinates: the same geometry
/// (every piece is its parent's polynomial restricted), the same groups, and
/// vertices shared where the parents share a face, an edge or a corner.
/// Piece (i, j, k) of cell c is cell i + n (j + n (k + n c)).
/// @pre tensor cells; n ≥ 1.
PartMesh<3> split_cells(const PartMesh<3>& mesh, int n);

/// The same, for n > 1 with geometry of kPieceDegree at most: on a cylinder it
/// adds, over half the angle of the parent, a few per cent to the parent's
/// error.
inline constexpr int kPieceDegree = 4;
PartMesh<3> refined(const PartMesh<3>& mesh, int n);

}  // namespace clevis::mesh
