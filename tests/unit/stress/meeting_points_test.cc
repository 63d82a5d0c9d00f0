#include "stress/peaks/meeting_points.h"

#include <cmath>
#include <functional>
#include <numeric>

#include <gtest/gtest.h>

#include "elasticity/assembly/supports.h"
#include "stress/field/stress_history.h"
#include "support/simplex_mesh.h"
#include "support/structured_mesh.h"

namespace clevis::stress {
namespace {

using Eigen::Vector3d;

/// A block whose cells are all different.
Vector3d bent(const Vector3d& x) {
  return {x[0] + 0.1 * x[1] * x[2], x[1] + 0.07 * x[0] * x[0],
          x[2] - 0.05 * x[0] * x[1]};
}

std::vector<int> all_cells(const elasticity::Discretization<3>& d) {
  std::vector<int> cells(d.cell_nodes.size());
  std::iota(cells.begin(), cells.end(), 0);
  return cells;
}

/// Largest distance of two points with one number, over all cells.
double largest_distance(const elasticity::Discretization<3>& d,
                        const MeetingPoints& points, int subdivisions) {
  std::vector<Vector3d> first(static_cast<std::size_t>(points.count),
                              Vector3d::Constant(1e9));
  double largest = 0.0;
  for (int k = 0; k < points.number.cols(); ++k) {
    for (int q = 0; q < points.number.rows(); ++q) {
      const Vector3d at = position<3>(d, {k, q}, subdivisions);
      auto& seen = first[static_cast<std::size_t>(points.number(q, k))];
      if (seen[0] == 1e9) seen = at;
      largest = std::max(largest, (at - seen).norm());
    }
  }
  return largest;
}

// As many points as a lattice over the whole block has, and those that are one
// lie at one place.
TEST(MeetingPoints, OfHexahedraAreThoseOfOneLattice) {
  const auto mesh = support::structured_mesh<3>({2, 3, 2}, 2, bent);
  const auto d = elasticity::discretize<3>(mesh, 3);
  const auto points = meeting_points<3>(d, all_cells(d), 4);
  EXPECT_EQ(points.count, 9 * 13 * 9);
  EXPECT_LT(largest_distance(d, points, 4), 1e-14);
}

TEST(MeetingPoints, OfTetrahedraAreThoseOfOneLattice) {
  const auto mesh = support::simplex_mesh<3>({2, 3, 2}, 2, bent);
  const auto d = elasticity::discretize<3>(mesh, 3);
  const auto points = meeting_points<3>(d, all_cells(d), 4);
  EXPECT_EQ(points.count, 9 * 13 * 9);
  EXPECT_LT(largest_distance(d, points, 4), 1e-14);
}

TEST(MeetingPoints, ValuesAreThoseOfAllCellsThere) {
  MeetingPoints points;
  points.number.resize(2, 2);
  points.number << 0, 1, 1, 2;
  points.count = 3;
  Eigen::MatrixXd values(2, 2);
  values << 1.0, 5.0, 3.0, 2.0;
  const auto met = meeting_values(points, values);
  EXPECT_EQ(met.mean, Vector3d(1.0, 4.0, 2.0));
  EXPECT_EQ(met.low, Vector3d(1.0, 3.0, 2.0));
  EXPECT_EQ(met.high, Vector3d(1.0, 5.0, 2.0));
}

elasticity::DisplacementBasis<3> field(
    const mesh::PartMesh<3>& mesh, int degree,
    const std::function<Vector3d(const Vector3d&)>& u) {
  elasticity::DisplacementBasis<3> basis;
  basis.discretization = elasticity::discretize<3>(mesh, degree);
  const auto at = elasticity::node_positions(basis.discretization);
  basis.columns.resize(basis.discretization.dofs(), 1);
  for (Eigen::Index i = 0; i < at.cols(); ++i) {
    basis.columns.block<3, 1>(3 * i, 0) = u(at.col(i));
  }
  basis.coefficients = Eigen::MatrixXd::Ones(1, 1);
  return basis;
}

// u = (c x², 0, 0) on flat cells: σ_xx - σ_yy = 2 μ u' = 4 μ c x, the largest
// von Mises. Degree 2 holds it, so that no cells differ; degree 1 does not.
TEST(JoinedStress, JumpsWhereTheDegreeFallsShortOnly) {
  const part::Material steel{"steel", 200e9, 0.25, 7850.0, 300e6};
  const double c = 1e-3;
  const auto mesh = support::simplex_mesh<3>({3, 2, 2}, 1, [](auto& x) {
    return Vector3d(x);
  });
  const auto parabola = [&](const Vector3d& x) {
    return Vector3d(c * x[0] * x[0], 0.0, 0.0);
  };
  const double wanted = 4.0 * 80e9 * c;  // at x = 1
  const auto exact = joined_stress<3>(field(mesh, 2, parabola), steel, 4);
  EXPECT_NEAR(exact.mean.maxCoeff(), wanted, 1e-9 * wanted);
  EXPECT_LT(exact.jump.maxCoeff(), 1e-9 * wanted);
  const auto poor = joined_stress<3>(field(mesh, 1, parabola), steel, 4);
  EXPECT_NEAR(poor.jump.maxCoeff(), wanted / 3.0, 1e-6 * wanted);
}

}  // namespace
}  // namespace clevis::stress
