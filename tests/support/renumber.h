#pragma once

#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <vector>

#include "mesh/cells/part_mesh.h"

namespace clevis::support {

/// The same mesh with cells in another order.
template <int dim>
mesh::PartMesh<dim> shuffled(const mesh::PartMesh<dim>& mesh, unsigned seed) {
  std::vector<std::size_t> from(mesh.cells.size());
  std::iota(from.begin(), from.end(), 0U);
  std::shuffle(from.begin(), from.end(), std::mt19937(seed));
  auto result = mesh;
  std::vector<int> to(from.size());
  for (std::size_t c = 0; c < from.size(); ++c) {
    result.cells[c] = mesh.cells[from[c]];
    result.cell_points[c] = mesh.cell_points[from[c]];
    to[from[c]] = static_cast<int>(c);
  }
  for (auto& face : result.boundary) {
    face.cell = to[static_cast<std::size_t>(face.cell)];
  }
  return result;
}

/// The same hexahedra, each seen along other axes of its own: direction d of
/// the new cell is direction axis[d] of the old, reversed if flip[d], right
/// handed.
inline mesh::PartMesh<3> reoriented(const mesh::PartMesh<3>& mesh,
                                    unsigned seed) {
  std::mt19937 random(seed);
  auto result = mesh;
  const int n = mesh.degree + 1;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    std::array<int, 3> axis{0, 1, 2};
    std::shuffle(axis.begin(), axis.end(), random);
    std::array<bool, 3> flip{};
    for (bool& f : flip) f = random() % 2 == 1;
    const bool odd = (axis[1] - axis[0] + 3) % 3 != 1;
    if (odd != ((flip[0] != flip[1]) != flip[2])) flip[2] = !flip[2];
    const auto source = [&](std::array<int, 3> index, int points) {
      int result_index = 0;
      for (std::size_t d = 0; d < 3; ++d) {
        const int along = flip[d] ? points - 1 - index[d] : index[d];
        int stride = 1;
        for (int k = 0; k < axis[d]; ++k) stride *= points;
        result_index += along * stride;
      }
      return result_index;
    };
    for (int v = 0; v < 8; ++v) {
      result.cells[c][static_cast<std::size_t>(v)] =
          mesh.cells[c][static_cast<std::size_t>(
              source({v & 1, (v >> 1) & 1, v >> 2}, 2))];
    }
    for (int q = 0; q < n * n * n; ++q) {
      result.cell_points[c].col(q) =
          mesh.cell_points[c].col(source({q % n, q / n % n, q / n / n}, n));
    }
    for (auto& face : result.boundary) {
      if (face.cell != static_cast<int>(c)) continue;
      for (std::size_t d = 0; d < 3; ++d) {
        if (axis[d] != face.face / 2) continue;
        const int side = (face.face % 2) ^ static_cast<int>(flip[d]);
        face.face = 2 * static_cast<int>(d) + side;
        break;
      }
    }
  }
  return result;
}

}  // namespace clevis::support
