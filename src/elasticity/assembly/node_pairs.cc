#include "elasticity/assembly/node_pairs.h"

#include <algorithm>
#include <cstddef>

namespace clevis::elasticity {

NodePairs node_pairs(const std::vector<std::vector<int>>& cell_nodes,
                     int nodes) {
  const auto count = static_cast<std::size_t>(nodes);
  std::vector<std::vector<std::size_t>> cells_of(count);
  for (std::size_t c = 0; c < cell_nodes.size(); ++c) {
    for (int i : cell_nodes[c]) {
      cells_of[static_cast<std::size_t>(i)].push_back(c);
    }
  }
  NodePairs pairs;
  std::vector<int> last_row(count, -1);
  pairs.row_start.assign(1, 0);
  for (int row = 0; row < nodes; ++row) {
    const auto begin = static_cast<std::ptrdiff_t>(pairs.column.size());
    for (const std::size_t c : cells_of[static_cast<std::size_t>(row)]) {
      for (int j : cell_nodes[c]) {
        auto& seen = last_row[static_cast<std::size_t>(j)];
        if (j < row || seen == row) continue;
        seen = row;
        pairs.column.push_back(j);
      }
    }
    std::sort(pairs.column.begin() + begin, pairs.column.end());
    pairs.row_start.push_back(static_cast<int>(pairs.column.size()));
  }
  return pairs;
}

}  // namespace clevis::elasticity
