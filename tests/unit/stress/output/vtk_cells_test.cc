#include "stress/output/vtk_cells.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace clevis::stress {
namespace {

using mesh::CellShape;

// As deal.II 9.4 writes them into files of version 0.1; VTK reads those in
// tests/regression/vtu_files.py.
TEST(VtkCells, LagrangeCellsAreOrderedAsDealiiOrdersThem) {
  EXPECT_EQ(
      lagrange_cell<2>(3).points.front(),
      (std::vector<int>{0, 3, 15, 12, 1, 2, 7, 11, 13, 14, 4, 8, 5, 6, 9, 10}));
  EXPECT_EQ(
      lagrange_cell<3>(2).points.front(),
      (std::vector<int>{0,  2,  8, 6,  18, 20, 26, 24, 1,  5,  7, 3,  19, 23,
                        25, 21, 9, 11, 15, 17, 12, 14, 10, 16, 4, 22, 13}));
  EXPECT_EQ(lagrange_cell<2>(3).type, 70);
  EXPECT_EQ(lagrange_cell<3>(2).type, 72);
}

TEST(VtkCells, LinearCellsGoRoundTheirPoints) {
  EXPECT_EQ(linear_cells<2>(CellShape::kTensor, 2).points.back(),
            (std::vector<int>{4, 5, 8, 7}));
  EXPECT_EQ(linear_cells<3>(CellShape::kTensor, 1).points.front(),
            (std::vector<int>{0, 1, 3, 2, 4, 5, 7, 6}));
  EXPECT_EQ(linear_cells<3>(CellShape::kTensor, 3).points.size(), 27U);
  EXPECT_EQ(linear_cells<3>(CellShape::kSimplex, 4).points.size(), 64U);
}

TEST(VtkCells, ALagrangeCellHasEveryPointOnce) {
  for (int n = 1; n <= 5; ++n) {
    auto points = lagrange_cell<3>(n).points.front();
    std::ranges::sort(points);
    ASSERT_EQ(points.size(),
              static_cast<std::size_t>((n + 1) * (n + 1) * (n + 1)));
    for (std::size_t k = 0; k < points.size(); ++k) {
      EXPECT_EQ(points[k], static_cast<int>(k));
    }
  }
}

}  // namespace
}  // namespace clevis::stress
