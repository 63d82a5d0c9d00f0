#include "elasticity/direct/node_groups.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "elasticity/fe_space/discretization.h"
#include "support/simplex_mesh.h"

namespace clevis::elasticity {
namespace {

Discretization<3> block(std::array<int, 3> cells, int degree) {
  return discretize<3>(support::simplex_mesh<3>(cells, 1,
                                                [](const Eigen::Vector3d& x) {
                                                  return x;
                                                }),
                       degree);
}

// A cube in six tetrahedra about its diagonal: 8 vertices, 19 edges, 18
// triangles, with 1, 3 and 3 nodes of degree 4, and one node in each cell. The
// triangles on the surface belong to one cell each, as do its inner node and
// those edges that no other cell has; these are one group.
TEST(NodeGroups, AreTheNodesOfTheSameCells) {
  const auto d = block({1, 1, 1}, 4);
  const NodeGroups groups = grouped_nodes(d.cell_nodes, d.nodes);
  std::vector<std::vector<int>> cells_of(static_cast<std::size_t>(d.nodes));
  for (int c = 0; c < d.cells(); ++c) {
    for (const int node : d.cell_nodes[static_cast<std::size_t>(c)]) {
      cells_of[static_cast<std::size_t>(node)].push_back(c);
    }
  }
  std::vector<std::vector<int>> different = cells_of;
  std::ranges::sort(different);
  different.erase(std::unique(different.begin(), different.end()),
                  different.end());
  EXPECT_EQ(groups.size(), static_cast<int>(different.size()));
  int nodes = 0;
  for (const auto& group : groups.nodes) {
    nodes += static_cast<int>(group.size());
    for (const int node : group) {
      EXPECT_EQ(cells_of[static_cast<std::size_t>(node)],
                cells_of[static_cast<std::size_t>(group.front())]);
    }
  }
  EXPECT_EQ(nodes, 8 * 1 + 19 * 3 + 18 * 3 + 6 * 1);
}

TEST(NodeGroups, LeaveOutNodesOfNoCell) {
  const NodeGroups groups = grouped_nodes({{1, 2, 5}, {2, 5, 6}}, 8);
  ASSERT_EQ(groups.size(), 3);
  EXPECT_EQ(groups.nodes, (std::vector<std::vector<int>>{{1}, {2, 5}, {6}}));
  EXPECT_EQ(neighbours(groups),
            (std::vector<std::vector<int>>{{1}, {0, 2}, {1}}));
}

TEST(NodeGroups, MetisOrdersEachGroupOnce) {
  for (const std::array<int, 3> cells :
       {std::array{1, 1, 1}, std::array{4, 3, 2}}) {
    const auto d = block(cells, 2);
    const auto groups = grouped_nodes(d.cell_nodes, d.nodes);
    auto order = metis_order(groups, neighbours(groups));
    std::vector<int> all(static_cast<std::size_t>(groups.size()));
    std::iota(all.begin(), all.end(), 0);
    std::ranges::sort(order);
    EXPECT_EQ(order, all);
  }
  // One cell alone: nothing to order.
  EXPECT_EQ(metis_order(grouped_nodes({{0, 1}}, 2), {{}}),
            (std::vector<int>{0}));
}

}  // namespace
}  // namespace clevis::elasticity
