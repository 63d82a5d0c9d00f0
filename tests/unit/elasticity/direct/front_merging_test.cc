// The fronts of METIS' order cover the matrix of a mesh of tetrahedra, whatever
// is merged.

#include "elasticity/direct/front_merging.h"

#include <cmath>

#include <gtest/gtest.h>

#include "elasticity/assembly/equations.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/direct/dissection.h"
#include "elasticity/direct/frontal_cholesky.h"
#include "support/simplex_mesh.h"

namespace clevis::elasticity {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;

const part::Material kSteel{"steel", 210e9, 0.3, 7850.0, 355e6};

Discretization<3> block(std::array<int, 3> cells, int degree) {
  const auto bent = [](const Vector3d& x) -> Vector3d {
    return {x[0] + 0.1 * x[1] * x[1], x[1], x[2]};
  };
  return discretize<3>(support::simplex_mesh<3>(cells, 2, bent), degree);
}

// Nodes 0 to 40 in a row, eliminated from the middle to the ends: as many
// entries as a tridiagonal factor has, but for few zeros, and every node once.
TEST(FrontMerging, CouplesTheNodesOfARow) {
  constexpr int kNodes = 41;
  std::vector<std::vector<int>> cells;
  for (int c = 0; c + 1 < kNodes; ++c) cells.push_back({c, c + 1});
  const NodeGroups row = grouped_nodes(cells, kNodes);
  std::vector<int> order;
  for (int k = 0; k < kNodes; ++k) {
    order.push_back(kNodes / 2 + (k % 2 == 0 ? k / 2 : -(k + 1) / 2));
  }
  const auto dissection = fronts_of(row, neighbours(row), order);
  int next = 0;
  for (const auto& front : dissection.fronts) {
    EXPECT_EQ(front.begin, next);
    next = front.end;
    EXPECT_LE(front.border.size(), 2U);
  }
  EXPECT_EQ(next, kNodes);
  EXPECT_EQ(dissection.order.size(), std::size_t{kNodes});
  EXPECT_TRUE(dissection.fronts.back().border.empty());
}

TEST(FrontMerging, SolvesWhatCholmodSolves) {
  for (const int degree : {1, 2, 3, 4}) {
    const auto part = block({5, 4, 3}, degree);
    const auto held = fixed_supports<3>(part, node_positions<3>(part),
                                        {{"x0", {true, true, true}}}, "block");
    const auto numbers = number_equations(part.dofs(), held);
    const auto matrix =
        free_equations(assemble_stiffness<3>(part, kSteel, "block"), numbers);
    const FrontalCholesky fronts(
        matrix, front_tree(dissect(part), 3, numbers.equation), "block");
    const MatrixXd b = MatrixXd::Random(matrix.rows(), 3);
    const MatrixXd expected = SparseCholesky(matrix, "block").solve(b);
    EXPECT_LT((fronts.solve(b) - expected).norm(), 1e-11 * expected.norm())
        << "degree " << degree;
  }
}

// A layer of n² cells after the other: its 2 (2n + 1)² nodes are eliminated
// beside the (2n + 1)² of the next face.
TEST(FrontMerging, CostsLessThanLayerByLayer) {
  constexpr int kCells = 8, kDegree = 2;
  const auto dissection = dissect(block({kCells, kCells, kCells}, kDegree));
  const double face = std::pow(kDegree * kCells + 1, 2);
  const double own = kDegree * face;
  const double layer = own * own * own / 3.0 + face * own * (own + face);
  EXPECT_LT(dissection.flops, kCells * layer);
}

}  // namespace
}  // namespace clevis::elasticity
