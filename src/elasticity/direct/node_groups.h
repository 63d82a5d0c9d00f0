#pragma once

#include <vector>

namespace clevis::elasticity {

/// Nodes that belong to the same cells: those of a vertex, of the inside of an
/// edge, a face or a cell. A factorisation need not tell them apart.
struct NodeGroups {
  std::vector<std::vector<int>> nodes;  ///< of each group, ascending
  std::vector<std::vector<int>> cells;  ///< groups of each cell

  int size() const { return static_cast<int>(nodes.size()); }
};

/// @param cell_nodes  of all cells.
/// @param nodes  how many there are; those of no cell are in no group.
NodeGroups grouped_nodes(const std::vector<std::vector<int>>& cell_nodes,
                         int nodes);

/// Groups that share a cell with each group, without itself, ascending.
std::vector<std::vector<int>> neighbours(const NodeGroups& groups);

/// Nested dissection of the groups by METIS, each group as heavy as it has
/// nodes: the order of elimination. The same on every run.
std::vector<int> metis_order(const NodeGroups& groups,
                             const std::vector<std::vector<int>>& neighbours);

}  // namespace clevis::elasticity
