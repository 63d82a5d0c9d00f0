#pragma once

#include <vector>

namespace clevis::elasticity {

/// Pairs of nodes that share a cell, the second not before the first: the
/// pattern of every matrix that is assembled of the cells.
struct NodePairs {
  std::vector<int> row_start;  ///< nodes + 1
  std::vector<int> column;     ///< sorted within a row
  int nodes() const { return static_cast<int>(row_start.size()) - 1; }
};

NodePairs node_pairs(const std::vector<std::vector<int>>& cell_nodes,
                     int nodes);

}  // namespace clevis::elasticity
