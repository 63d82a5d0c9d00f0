#include "stress/peaks/lattice_maximum.h"

#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "elasticity/fe_space/tabulation.h"

namespace clevis::stress {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kSubdivisions = 8;

template <int dim>
using Field = std::function<double(const Eigen::Matrix<double, dim, 1>&)>;

/// Largest value at the points, and what stands between them besides.
template <int dim>
struct Found {
  double at_points{}, rise{};
};

template <int dim>
Found<dim> found(mesh::CellShape shape, const Field<dim>& field) {
  const auto lattice = elasticity::lattice<dim>(shape, kSubdivisions);
  VectorXd values(lattice.cols());
  for (Index i = 0; i < values.size(); ++i) values[i] = field(lattice.col(i));
  Index at = 0;
  const double highest = values.maxCoeff(&at);
  return {highest, rise_between_points<dim>(shape, kSubdivisions, values,
                                            VectorXd::Ones(values.size()), at)};
}

TEST(LatticeMaximum, QuadraticFieldBetweenPoints) {
  const Vector2d top(0.44, 0.56);
  const auto flat = found<2>(mesh::CellShape::kTensor, [&](const Vector2d& x) {
    const Vector2d d = x - top;
    return 7.0 - d[0] * d[0] - 2.0 * d[1] * d[1] + 0.5 * d[0] * d[1];
  });
  EXPECT_LT(flat.at_points, 6.995);
  EXPECT_NEAR(flat.at_points + flat.rise, 7.0, 2e-4);
}

TEST(LatticeMaximum, OnAFaceOfACube) {
  // Falls into the cell, so that the maximum is on the face x = 0.
  const Vector3d top(0.0, 0.44, 0.44);
  const auto solid = found<3>(mesh::CellShape::kTensor, [&](const Vector3d& x) {
    const Vector3d d = x - top;
    return 3.0 - 2.0 * d[0] - d[1] * d[1] - d[2] * d[2] + 0.3 * d[0] * d[1];
  });
  EXPECT_LT(solid.at_points, 2.993);
  EXPECT_NEAR(solid.at_points + solid.rise, 3.0, 2e-4);
}

TEST(LatticeMaximum, OnAnEdgeOfATetrahedron) {
  const Vector3d top(0.0, 0.0, 0.44);
  const auto solid =
      found<3>(mesh::CellShape::kSimplex, [&](const Vector3d& x) {
        const Vector3d d = x - top;
        return 3.0 - 2.0 * d[0] - d[1] - d[2] * d[2];
      });
  EXPECT_LT(solid.at_points, 2.997);
  EXPECT_NEAR(solid.at_points + solid.rise, 3.0, 2e-4);
}

// What rises towards a corner that is left out does not count from there on.
TEST(LatticeMaximum, NothingOfWhatIsLeftOut) {
  constexpr double kOut = 0.35;
  const auto lattice =
      elasticity::lattice<3>(mesh::CellShape::kSimplex, kSubdivisions);
  const VectorXd away = lattice.colwise().norm();
  const VectorXd values = away.cwiseMax(0.05).cwiseInverse();
  VectorXd counting = VectorXd::Ones(away.size());
  Index at = 0;
  double highest = 0.0;
  for (Index i = 0; i < away.size(); ++i) {
    if (away[i] < kOut) counting[i] = 0.0;
    if (counting[i] == 0.0 || values[i] <= highest) continue;
    highest = values[i];
    at = i;
  }
  const double rise = rise_between_points<3>(
      mesh::CellShape::kSimplex, kSubdivisions, values, counting, at);
  EXPECT_LE(highest + rise, 1.0 / kOut);
  EXPECT_LT(rise, 0.02 * highest);
}

TEST(LatticeMaximum, HoopStressOfAHoleInCellsOf45Degrees) {
  // Kirsch, round the hole: 1 - 2 cos 2 theta, at most 3.
  const auto hole = found<2>(mesh::CellShape::kTensor, [](const Vector2d& x) {
    const double theta = std::numbers::pi * (0.25 * x[0] + 0.5 - 0.11);
    return (1.0 - 2.0 * std::cos(2.0 * theta)) * (1.0 - 0.3 * x[1]);
  });
  const double missed = 3.0 - hole.at_points;
  EXPECT_GT(missed, 3e-3);
  EXPECT_LT(std::abs(missed - hole.rise), 0.1 * missed);
}

// Beside a free face a stress may fall within one spacing: a parabola through
// that would rise above the points by a tenth of the fall.
TEST(LatticeMaximum, NothingBesideASteepSide) {
  constexpr double kFall = 0.1;
  const auto side = found<3>(mesh::CellShape::kTensor, [](const Vector3d& x) {
    const double beyond = std::max(0.0, kSubdivisions * (x[2] - 0.875));
    return 3.0 + 0.001 * x[2] - kFall * beyond * beyond -
           0.05 * std::pow(x[0] - 0.5, 2) - 0.1 * x[1];
  });
  EXPECT_LT(side.rise, 0.002 * kFall + 0.001 / kSubdivisions);
}

// Steep across, round along: what stands between the points along is found.
TEST(LatticeMaximum, BesideASteepSideAlongIt) {
  const auto side = found<3>(mesh::CellShape::kTensor, [](const Vector3d& x) {
    const double beyond = std::max(0.0, kSubdivisions * (x[2] - 0.875));
    return 3.0 + 0.001 * x[2] - 0.1 * beyond * beyond -
           0.5 * std::pow(x[0] - 0.44, 2) - 0.1 * x[1];
  });
  const double missed = 3.0 + 0.001 * 0.875 - side.at_points;
  EXPECT_GT(missed, 1e-3);
  EXPECT_NEAR(side.rise, missed, 0.1 * missed);
}

TEST(LatticeMaximum, NothingAboveASlopeNorWhereNoPointCounts) {
  const auto slope = found<3>(mesh::CellShape::kTensor, [](const Vector3d& x) {
    return x[0] - 0.5 * x[1] + x[2];
  });
  EXPECT_NEAR(slope.rise, 0.0, 1e-12);
  const auto points = elasticity::lattice<2>(mesh::CellShape::kTensor, 2);
  const VectorXd values = 1.0 - (points.colwise() - Vector2d(0.6, 0.5))
                                    .colwise()
                                    .squaredNorm()
                                    .transpose()
                                    .array();
  const VectorXd all = VectorXd::Ones(points.cols());
  EXPECT_NEAR(
      rise_between_points<2>(mesh::CellShape::kTensor, 2, values, all, 4), 0.01,
      1e-3);
  VectorXd alone = VectorXd::Zero(points.cols());
  alone[4] = 1.0;
  EXPECT_EQ(
      rise_between_points<2>(mesh::CellShape::kTensor, 2, values, alone, 4),
      0.0);
}

}  // namespace
}  // namespace clevis::stress
