#pragma once

#include <cstddef>
#include <vector>

namespace clevis::elasticity {

/// Degrees of freedom of the continuous Lagrange element on a mesh of
/// quadrangles or hexahedra.
struct TensorNumbering {
  int nodes{};
  std::vector<std::vector<int>> cell_nodes;  ///< in mesh::cell_parts order
  std::vector<int> vertex_nodes;             ///< −1: vertex of no cell
};

/// Numbers the nodes in the order in which the cells meet them: corners, edges,
/// faces and the inside of one cell after the other. Cells need no common
/// orientation.
/// @param cells     vertices per cell, lexicographic.
/// @param vertices  of the mesh.
template <int dim>
TensorNumbering number_tensor_cells(
    const std::vector<std::vector<unsigned>>& cells, std::size_t vertices,
    int degree);

}  // namespace clevis::elasticity
