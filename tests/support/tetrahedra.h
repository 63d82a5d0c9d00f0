#pragma once

#include <algorithm>
#include <array>

#include <Eigen/LU>

#include "support/structured_mesh.h"

namespace clevis::support {

/// Every hexahedron of a mesh of degree 1 split into six tetrahedra about its
/// diagonal (Kuhn), with the same groups.
inline mesh::PartMesh<3> tetrahedra(const mesh::PartMesh<3>& hexes) {
  mesh::PartMesh<3> result;
  result.shape = mesh::CellShape::kSimplex;
  result.vertices = hexes.vertices;
  result.groups = hexes.groups;
  // Vertices of a tetrahedron's face, deal.II's numbering.
  constexpr int kFaces[4][3] = {{0, 1, 2}, {1, 0, 3}, {0, 2, 3}, {2, 1, 3}};
  for (std::size_t c = 0; c < hexes.cells.size(); ++c) {
    std::array<int, 3> axes{0, 1, 2};
    do {
      std::array<unsigned, 4> corner{};  // of the hexahedron
      for (std::size_t k = 0; k < 3; ++k) {
        corner[k + 1] = corner[k] | (1U << axes[k]);
      }
      Eigen::Matrix3Xd points(3, 4);
      const auto place = [&] {
        for (std::size_t v = 0; v < 4; ++v) {
          points.col(static_cast<Eigen::Index>(v)) =
              hexes.vertices[hexes.cells[c][corner[v]]];
        }
        Eigen::Matrix3d edges;
        for (int k = 0; k < 3; ++k) {
          edges.col(k) = points.col(k + 1) - points.col(0);
        }
        return edges.determinant();
      };
      if (place() < 0.0) {
        std::swap(corner[2], corner[3]);
        place();
      }
      const int cell = static_cast<int>(result.cells.size());
      std::vector<unsigned> ids;
      for (unsigned v : corner) ids.push_back(hexes.cells[c][v]);
      result.cells.push_back(ids);
      result.cell_points.push_back(points);
      for (const auto& face : hexes.boundary) {
        if (face.cell != static_cast<int>(c)) continue;
        const auto side = static_cast<unsigned>(face.face % 2);
        for (int f = 0; f < 4; ++f) {
          const bool on_side = std::ranges::all_of(kFaces[f], [&](int v) {
            return ((corner[static_cast<std::size_t>(v)] >> (face.face / 2)) &
                    1U) == side;
          });
          if (on_side) result.boundary.push_back({cell, f, face.group});
        }
      }
    } while (std::ranges::next_permutation(axes).found);
  }
  return result;
}

}  // namespace clevis::support
