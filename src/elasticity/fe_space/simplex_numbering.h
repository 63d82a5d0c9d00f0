#pragma once

#include <vector>

#include "mesh/cells/part_mesh.h"

namespace clevis::elasticity {

/// Degrees of freedom of the continuous Lagrange element on a mesh of
/// simplices.
struct SimplexNumbering {
  int nodes{};
  std::vector<std::vector<int>> cell_nodes;  ///< in mesh::simplex_lattice order
  std::vector<int> vertex_nodes;             ///< −1: vertex of no cell
};

/// Numbers the nodes in the order in which the cells meet them. Two local
/// nodes are one if they have the same barycentric coordinates with respect
/// to the same vertices: cells need no common orientation.
template <int dim>
SimplexNumbering number_simplices(const mesh::PartMesh<dim>& mesh, int degree);

}  // namespace clevis::elasticity
