#include "elasticity/direct/node_groups.h"

#include <algorithm>
#include <array>
#include <numeric>

#include <metis.h>

#include "base/messages/errors.h"

namespace clevis::elasticity {

namespace {

/// Classes of nodes, which every cell splits into those that it has and those
/// that it has not: afterwards the nodes of a class have the same cells.
std::vector<int> classes_of(const std::vector<std::vector<int>>& cell_nodes,
                            int nodes) {
  std::vector<int> class_of(static_cast<std::size_t>(nodes), 0);
  std::vector<int> split{0};      // per class: what the last cell made of it
  std::vector<int> split_by{-1};  // that cell
  for (std::size_t c = 0; c < cell_nodes.size(); ++c) {
    const int cell = static_cast<int>(c);
    for (const int node : cell_nodes[c]) {
      int& own = class_of[static_cast<std::size_t>(node)];
      const auto from = static_cast<std::size_t>(own);
      if (split_by[from] != cell) {
        split_by[from] = cell;
        split[from] = static_cast<int>(split.size());
        split.push_back(0);
        split_by.push_back(-1);
      }
      own = split[from];
    }
  }
  return class_of;
}

}  // namespace

NodeGroups grouped_nodes(const std::vector<std::vector<int>>& cell_nodes,
                         int nodes) {
  const std::vector<int> class_of = classes_of(cell_nodes, nodes);
  NodeGroups groups;
  std::vector<int> number;  // per class
  for (std::size_t node = 0; node < class_of.size(); ++node) {
    const auto of = static_cast<std::size_t>(class_of[node]);
    if (of == 0) continue;  // of no cell
    if (number.size() <= of) number.resize(of + 1, -1);
    if (number[of] < 0) {
      number[of] = groups.size();
      groups.nodes.emplace_back();
    }
    groups.nodes[static_cast<std::size_t>(number[of])].push_back(
        static_cast<int>(node));
  }
  for (const auto& ids : cell_nodes) {
    auto& of_cell = groups.cells.emplace_back();
    for (const int node : ids) {
      const int of = class_of[static_cast<std::size_t>(node)];
      of_cell.push_back(number[static_cast<std::size_t>(of)]);
    }
    std::ranges::sort(of_cell);
    of_cell.erase(std::unique(of_cell.begin(), of_cell.end()), of_cell.end());
  }
  return groups;
}

std::vector<std::vector<int>> neighbours(const NodeGroups& groups) {
  const auto n = static_cast<std::size_t>(groups.size());
  std::vector<std::vector<int>> cells_of(n);
  for (std::size_t c = 0; c < groups.cells.size(); ++c) {
    for (const int group : groups.cells[c]) {
      cells_of[static_cast<std::size_t>(group)].push_back(static_cast<int>(c));
    }
  }
  std::vector<std::vector<int>> result(n);
  std::vector<int> seen(n, -1);
  for (std::size_t g = 0; g < n; ++g) {
    const int own = static_cast<int>(g);
    seen[g] = own;
    for (const int cell : cells_of[g]) {
      for (const int other : groups.cells[static_cast<std::size_t>(cell)]) {
        int& mark = seen[static_cast<std::size_t>(other)];
        if (mark == own) continue;
        mark = own;
        result[g].push_back(other);
      }
    }
    std::ranges::sort(result[g]);
  }
  return result;
}

std::vector<int> metis_order(const NodeGroups& groups,
                             const std::vector<std::vector<int>>& neighbours) {
  std::vector<idx_t> start{0}, adjacent, weight;
  for (const auto& list : neighbours) {
    adjacent.insert(adjacent.end(), list.begin(), list.end());
    start.push_back(static_cast<idx_t>(adjacent.size()));
  }
  for (const auto& nodes : groups.nodes) {
    weight.push_back(static_cast<idx_t>(nodes.size()));
  }
  const auto n = static_cast<std::size_t>(groups.size());
  std::vector<idx_t> order(n), place(n);
  if (adjacent.empty()) {  // which METIS does not take
    std::iota(order.begin(), order.end(), 0);
    return {order.begin(), order.end()};
  }
  std::array<idx_t, METIS_NOPTIONS> options{};
  METIS_SetDefaultOptions(options.data());
  options[METIS_OPTION_COMPRESS] = 0;  // groups have nothing in common
  auto count = static_cast<idx_t>(n);
  const int said =
      METIS_NodeND(&count, start.data(), adjacent.data(), weight.data(),
                   options.data(), order.data(), place.data());
  if (said != METIS_OK) {
    throw Error("X001", "dissection", "METIS cannot order the nodes",
                "Please report this scene.");
  }
  return {order.begin(), order.end()};
}

}  // namespace clevis::elasticity
