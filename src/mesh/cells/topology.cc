#include "mesh/cells/topology.h"

#include <algorithm>

#include "mesh/basis/simplex_basis.h"

namespace clevis::mesh {

FaceVertices face_vertices(const PartMesh<3>& mesh, int cell, int face) {
  const auto& vertices = mesh.cells[std::size_t(cell)];
  if (mesh.shape == CellShape::kSimplex) {
    const auto& local = simplex_face<3>(face);
    return {vertices[std::size_t(local[0])], vertices[std::size_t(local[1])],
            vertices[std::size_t(local[2])], kNoVertex};
  }
  const int axis = face / 2, side = face % 2;
  FaceVertices corners{};
  std::size_t n = 0;
  for (std::size_t v = 0; v < 8; ++v) {
    if (((int(v) >> axis) & 1) == side) corners[n++] = vertices[v];
  }
  return corners;
}

FaceVertices face_vertices(const PartMesh<2>& mesh, int cell, int face) {
  static constexpr std::size_t kTensor[4][2] = {{0, 2}, {1, 3}, {0, 1}, {2, 3}};
  static constexpr std::size_t kSimplex[3][2] = {{0, 1}, {1, 2}, {2, 0}};
  const auto& ends =
      mesh.shape == CellShape::kTensor ? kTensor[face] : kSimplex[face];
  const auto& vertices = mesh.cells[std::size_t(cell)];
  return {vertices[ends[0]], vertices[ends[1]], kNoVertex, kNoVertex};
}

int faces_per_cell(CellShape shape) {
  return shape == CellShape::kTensor ? 6 : 4;
}

const std::array<HexEdge, 12>& hex_edges() {
  static const std::array<HexEdge, 12> edges = [] {
    std::array<HexEdge, 12> all{};
    std::size_t n = 0;
    for (int axis = 0; axis < 3; ++axis) {
      for (int v = 0; v < 8; ++v) {
        if (((v >> axis) & 1) == 0) all[n++] = {axis, v, v | (1 << axis)};
      }
    }
    return all;
  }();
  return edges;
}

std::vector<CellFace> sorted_faces(const PartMesh<3>& mesh) {
  std::vector<CellFace> faces;
  const int per_cell = faces_per_cell(mesh.shape);
  faces.reserve(mesh.cells.size() * std::size_t(per_cell));
  for (int cell = 0; cell < int(mesh.cells.size()); ++cell) {
    for (int face = 0; face < per_cell; ++face) {
      FaceVertices corners = face_vertices(mesh, cell, face);
      std::sort(corners.begin(), corners.end());
      faces.push_back({corners, cell, face});
    }
  }
  std::stable_sort(faces.begin(), faces.end(),
                   [](const auto& a, const auto& b) {
                     return a.corners < b.corners;
                   });
  return faces;
}

std::vector<std::array<std::pair<int, int>, 6>> neighbours(
    const PartMesh<3>& mesh) {
  std::array<std::pair<int, int>, 6> outside;
  outside.fill({-1, -1});
  std::vector<std::array<std::pair<int, int>, 6>> other(mesh.cells.size(),
                                                        outside);
  const auto faces = sorted_faces(mesh);
  for (std::size_t i = 1; i < faces.size(); ++i) {
    const CellFace &a = faces[i - 1], &b = faces[i];
    if (a.corners != b.corners) continue;
    other[std::size_t(a.cell)][std::size_t(a.face)] = {b.cell, b.face};
    other[std::size_t(b.cell)][std::size_t(b.face)] = {a.cell, a.face};
  }
  return other;
}

double size_of(const PartMesh<3>& mesh) {
  if (mesh.vertices.empty()) return 0.0;
  Eigen::Vector3d low = mesh.vertices[0], high = low;
  for (const auto& v : mesh.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  return (high - low).norm();
}

}  // namespace clevis::mesh
