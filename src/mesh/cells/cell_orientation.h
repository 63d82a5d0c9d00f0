#pragma once

#include <vector>

namespace clevis::mesh {

/// Turns the reference directions of quadrangles or hexahedra so that two cells
/// run along an edge that they share the same way. Cells that do so already
/// stay as they are, and so do hexahedra that cannot all: some meshes like a
/// Möbius strip have no such directions.
///
/// Edges that face each other in a cell have one direction: it spreads from
/// cell to cell in linear time, as in deal.II's consistently_order_cells, with
/// which it agrees.
///
/// @param cells  vertices per cell, lexicographic.
template <int dim>
void orient_cells(std::vector<std::vector<unsigned>>& cells);

}  // namespace clevis::mesh
