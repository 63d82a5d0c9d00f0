#include "elasticity/direct/separator.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "elasticity/direct/dissection.h"
#include "support/simplex_mesh.h"

namespace clevis::elasticity {
namespace {

using Cells = std::vector<std::size_t>;

/// Quadrilaterals in a row; nodes 2i and 2i + 1 between the cells.
std::vector<std::vector<int>> strip(int cells) {
  std::vector<std::vector<int>> nodes;
  for (int c = 0; c < cells; ++c) {
    nodes.push_back({2 * c, 2 * c + 1, 2 * c + 2, 2 * c + 3});
  }
  return nodes;
}

TEST(Separator, TakesACellBackThatStandsAmongTheOthers) {
  const auto nodes = strip(10);
  Separator separator(nodes, 22);
  Cells cells = {0, 1, 2, 3, 5, 4, 6, 7, 8, 9};
  const std::vector<char> counts(22, 1);
  const auto half = separator.shorten(cells, 5, counts);
  EXPECT_EQ(half, 4U);
  std::ranges::sort(cells.begin(), cells.begin() + 4);
  std::ranges::sort(cells.begin() + 4, cells.end());
  EXPECT_EQ(cells, (Cells{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
}

TEST(Separator, LeavesTheShortestBorderAlone) {
  const auto nodes = strip(10);
  Separator separator(nodes, 22);
  Cells cells = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  const Cells before = cells;
  const std::vector<char> counts(22, 1);
  EXPECT_EQ(separator.shorten(cells, 5, counts), 5U);
  EXPECT_EQ(cells, before);
}

// Nodes that a separator holds already are no reason to move, and no set ends
// empty.
TEST(Separator, CountsOpenNodesOnlyAndKeepsBothSets) {
  const auto nodes = strip(10);
  Separator separator(nodes, 22);
  Cells cells = {0, 1, 2, 3, 5, 4, 6, 7, 8, 9};
  EXPECT_EQ(separator.shorten(cells, 5, std::vector<char>(22, 0)), 5U);
  Cells two = {0, 1};
  EXPECT_EQ(separator.shorten(two, 1, std::vector<char>(22, 1)), 1U);
}

// All nodes once, whatever the cells are.
TEST(Separator, DissectionOrdersEveryNodeOnce) {
  const auto mesh = support::simplex_mesh<3>(
      {4, 3, 2}, 1, [](const Eigen::Vector3d& x) -> Eigen::Vector3d {
        return x + 0.05 * Eigen::Vector3d(std::sin(9 * x[1]),
                                          std::sin(7 * x[2] + x[0]), 0.0);
      });
  const auto d = discretize<3>(mesh, 3);
  auto order = dissect<3>(d).order;
  ASSERT_EQ(order.size(), static_cast<std::size_t>(d.nodes));
  std::ranges::sort(order);
  for (int i = 0; i < d.nodes; ++i) {
    EXPECT_EQ(order[static_cast<std::size_t>(i)], i);
  }
}

}  // namespace
}  // namespace clevis::elasticity
