#pragma once

#include <cstdint>
#include <vector>

#include "mesh/cells/part_mesh.h"

namespace clevis::stress {

/// VTK's cells of one cell of a mesh, by its lattice points.
struct VtkCells {
  std::uint8_t type{};                        ///< VTK's number
  std::vector<std::vector<int>> points = {};  ///< per cell, in VTK's order
};

/// One Lagrange cell of the lattice's order.
/// @param shape  tensor cells.
template <int dim>
VtkCells lagrange_cell(int subdivisions);

/// The lattice as linear cells.
template <int dim>
VtkCells linear_cells(mesh::CellShape shape, int subdivisions);

}  // namespace clevis::stress
