#pragma once

#include <vector>

#include "mesh/cells/part_mesh.h"

namespace clevis::mesh {

/// Some cells of a mesh as a mesh of their own, with its groups; faces towards
/// the other cells belong to no boundary.
template <int dim>
struct SubMesh {
  PartMesh<dim> mesh;
  std::vector<int> cells;  ///< of the whole mesh, one per cell of `mesh`
};

/// @param cells  ascending.
template <int dim>
SubMesh<dim> sub_mesh(const PartMesh<dim>& whole, std::vector<int> cells);

/// The cells and, `layers` times, all that share a vertex with them; ascending.
template <int dim>
std::vector<int> with_neighbours(const PartMesh<dim>& mesh,
                                 std::vector<int> cells, int layers = 1);

}  // namespace clevis::mesh
