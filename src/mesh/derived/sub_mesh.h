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

/// Those neighbours, and where cells are slender as many more as come as close
/// to the centre as half its longest edge per layer: what cells do not resolve
/// along their length decays as slowly to their sides.
/// @param centre  cells, ascending.
/// @return ascending; cells that are close do not make more than 200 of them.
template <int dim>
std::vector<int> surroundings(const PartMesh<dim>& mesh,
                              const std::vector<int>& centre, int layers);

}  // namespace clevis::mesh
