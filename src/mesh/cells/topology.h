#pragma once

#include <array>
#include <utility>
#include <vector>

#include "mesh/cells/part_mesh.h"

namespace clevis::mesh {

/// Vertices of a local face, in PartMesh's numbering; the fourth of a
/// triangle and the last two of a plane mesh's edge are kNoVertex.
inline constexpr unsigned kNoVertex = ~0u;
using FaceVertices = std::array<unsigned, 4>;
FaceVertices face_vertices(const PartMesh<3>& mesh, int cell, int face);
FaceVertices face_vertices(const PartMesh<2>& mesh, int cell, int face);
int faces_per_cell(CellShape shape);

/// A local edge of a hexahedron: along which direction it runs, and its two
/// local vertices, the second at ξ = 1.
struct HexEdge {
  int axis{}, from{}, to{};
};
const std::array<HexEdge, 12>& hex_edges();

/// One side of a face; its corners sorted.
struct CellFace {
  FaceVertices corners;
  int cell{}, face{};
};

/// All faces of all cells, sorted by corners: the two sides of an inner face
/// stand side by side.
std::vector<CellFace> sorted_faces(const PartMesh<3>& mesh);

/// Other side (cell, local face) of each local face; cell -1 outside.
std::vector<std::array<std::pair<int, int>, 6>> neighbours(
    const PartMesh<3>& mesh);

/// Length of the diagonal of the box around the vertices [m].
double size_of(const PartMesh<3>& mesh);

}  // namespace clevis::mesh
