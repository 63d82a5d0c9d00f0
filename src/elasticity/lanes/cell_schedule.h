#pragma once

#include <utility>
#include <vector>

#include "elasticity/fe_space/discretization.h"

namespace clevis::elasticity {

/// Cells in an order that keeps neighbours together, cut into a fixed number
/// of parts that threads work on one by one. The parts don't depend on the
/// number of threads, nor does anything summed over them.
struct CellSchedule {
  std::vector<int> cell;        ///< place in the order → cell of the mesh
  std::vector<int> part_start;  ///< parts + 1, into the order

  int cells() const { return static_cast<int>(cell.size()); }
  int parts() const { return static_cast<int>(part_start.size()) - 1; }
};

/// Recursive bisection of the cells' centres, along the longest extent.
CellSchedule schedule_cells(const Discretization<3>& discretization);

/// Nodes of one degree on the scheduled cells, numbered as cells first touch
/// them: a part's own nodes are one range.
///
/// Sums into nodes of an earlier part go to `ghosts`, places nodes … nodes +
/// ghosts − 1, and are added afterwards in the order of the parts.
struct NodeTable {
  int degree{};
  int nodes{};
  std::vector<int> gather;      ///< cells × (degree + 1)³, lexicographic
  std::vector<int> scatter;     ///< lanes::ApplyArguments::scatter
  std::vector<int> part_start;  ///< parts + 1, into the nodes
  /// (node, place in the ghosts) in the order of summation, and where those
  /// start that belong to each part's nodes.
  std::vector<std::pair<int, int>> ghosts;
  std::vector<int> ghost_start;

  int nodes_per_cell() const {
    return (degree + 1) * (degree + 1) * (degree + 1);
  }
};

/// The table of the discretisation's own nodes, and their numbers in it.
struct FineNodes {
  NodeTable table;
  std::vector<int> number;  ///< node of the discretisation → of the table
};
FineNodes number_nodes(const Discretization<3>& discretization,
                       const CellSchedule& schedule);

/// The table of a lower degree (1 or 2) on the same cells.
NodeTable coarsen(const NodeTable& fine, const CellSchedule& schedule,
                  int degree);

/// Local node of the displacement basis at each lexicographic place.
std::vector<int> lexicographic_order(int degree);

}  // namespace clevis::elasticity
