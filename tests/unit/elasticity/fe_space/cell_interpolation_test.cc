#include "elasticity/fe_space/cell_interpolation.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "elasticity/fe_space/tabulation.h"

namespace clevis::elasticity {
namespace {

using Eigen::MatrixXd;
using mesh::CellShape;

/// Largest difference between the interpolation and the table of all functions
/// at all points.
template <int dim>
double difference(CellShape shape, Degree degree,
                  const ReferencePoints<dim>& points) {
  const auto table = tabulate_geometry<dim>(shape, degree, points);
  const CellInterpolation<dim> interpolation(shape, degree, points);
  EXPECT_EQ(interpolation.points(), points.cols());
  const MatrixXd nodal = MatrixXd::Random(table.values.cols(), 5);
  double largest = (interpolation.values(nodal) - table.values * nodal)
                       .cwiseAbs()
                       .maxCoeff();
  const MatrixXd gradients = interpolation.gradients(nodal);
  for (int d = 0; d < dim; ++d) {
    const MatrixXd expected =
        table.gradients[static_cast<std::size_t>(d)] * nodal;
    largest = std::max(
        largest,
        (gradients.middleRows(d * points.cols(), points.cols()) - expected)
            .cwiseAbs()
            .maxCoeff());
  }
  return largest;
}

TEST(CellInterpolation, EqualsTheTableOnGrids) {
  for (int p = 1; p <= 4; ++p) {
    for (const int intervals : {1, 2, 5, 16}) {
      const auto shape = CellShape::kTensor;
      EXPECT_LT(difference<2>(shape, p, lattice<2>(shape, intervals)), 1e-12);
      EXPECT_LT(difference<3>(shape, {p, 5 - p}, lattice<3>(shape, intervals)),
                1e-12);
    }
  }
}

TEST(CellInterpolation, EqualsTheTableOnUnequalGridsAndFaces) {
  const auto shape = CellShape::kTensor;
  EXPECT_LT(difference<3>(shape, {3, 2}, gauss<3>(shape, {4, 2}).points),
            1e-12);
  for (int face = 0; face < 6; ++face) {
    EXPECT_LT(
        difference<3>(shape, {2, 4}, face_gauss<3>(shape, face, {5, 3}).points),
        1e-12);
  }
}

TEST(CellInterpolation, EqualsTheTableAtScatteredPoints) {
  const auto shape = CellShape::kTensor;
  for (const int count : {1, 2, 4, 8, 27}) {
    const ReferencePoints<3> points =
        0.5 * (ReferencePoints<3>::Random(3, count).array() + 1.0);
    EXPECT_LT(difference<3>(shape, 3, points), 1e-12);
  }
  // Grids less a point or with one moved are none.
  ReferencePoints<3> points = lattice<3>(shape, 2);
  EXPECT_LT(difference<3>(shape, 3, points.leftCols<26>()), 1e-12);
  points(1, 13) += 0.1;
  EXPECT_LT(difference<3>(shape, 3, points), 1e-12);
  points = lattice<3>(shape, 2);
  points.col(4).swap(points.col(5));
  EXPECT_LT(difference<3>(shape, 3, points), 1e-12);
}

TEST(CellInterpolation, EqualsTheTableInSimplices) {
  const auto shape = CellShape::kSimplex;
  for (int p = 1; p <= 4; ++p) {
    EXPECT_LT(difference<2>(shape, p, lattice<2>(shape, 4)), 1e-12);
    EXPECT_LT(difference<3>(shape, p, lattice<3>(shape, 4)), 1e-12);
  }
}

}  // namespace
}  // namespace clevis::elasticity
