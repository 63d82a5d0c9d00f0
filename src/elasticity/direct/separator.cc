#include "elasticity/direct/separator.h"

#include <algorithm>

namespace clevis::elasticity {

/// How many nodes less are shared if the cell changes sides.
int Separator::gain(std::size_t cell, const std::vector<char>& counts) const {
  const auto own = static_cast<std::size_t>(set_[cell]);
  int gain = 0;
  for (const int node : cell_nodes_[cell]) {
    const auto n = static_cast<std::size_t>(node);
    if (counts[n] == 0) continue;
    const bool stands_elsewhere = at_node_[1 - own][n] > 0;
    const bool is_last = at_node_[own][n] == 1;
    if (is_last && stands_elsewhere) ++gain;
    if (!is_last && !stands_elsewhere) --gain;
  }
  return gain;
}

void Separator::move(std::size_t cell) {
  const auto own = static_cast<std::size_t>(set_[cell]);
  for (const int node : cell_nodes_[cell]) {
    const auto n = static_cast<std::size_t>(node);
    --at_node_[own][n];
    ++at_node_[1 - own][n];
  }
  set_[cell] = static_cast<char>(1 - own);
}

std::size_t Separator::shorten(std::span<std::size_t> cells, std::size_t half,
                               const std::vector<char>& counts) {
  constexpr int kRounds = 8;
  std::array<std::size_t, 2> size = {half, cells.size() - half};
  const std::size_t least = std::max<std::size_t>(2 * cells.size() / 5, 1);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    set_[cells[k]] = k < half ? 0 : 1;
    for (const int node : cell_nodes_[cells[k]]) {
      ++at_node_[k < half ? 0 : 1][static_cast<std::size_t>(node)];
    }
  }
  bool moved = true;
  for (int round = 0; moved && round < kRounds; ++round) {
    moved = false;
    for (const std::size_t cell : cells) {
      const auto own = static_cast<std::size_t>(set_[cell]);
      if (size[own] <= least || gain(cell, counts) <= 0) continue;
      move(cell);
      --size[own];
      ++size[1 - own];
      moved = true;
    }
  }
  for (const std::size_t cell : cells) {
    for (const int node : cell_nodes_[cell]) {
      at_node_[0][static_cast<std::size_t>(node)] = 0;
      at_node_[1][static_cast<std::size_t>(node)] = 0;
    }
  }
  std::ranges::stable_partition(cells, [&](std::size_t cell) {
    return set_[cell] == 0;
  });
  return size[0];
}

}  // namespace clevis::elasticity
