// Quadrature of cut faces against the areas and moments of what is left.
#include "elasticity/nodal_loads/zone_trace.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/annulus_mesh.h"
#include "support/simplex_mesh.h"
#include "support/structured_mesh.h"

namespace clevis::elasticity {
namespace {

using Eigen::Vector3d;

/// Area, ∫ p dA and ∫ x² dA of a trace.
struct Moments {
  double area = 0.0, xx = 0.0;
  Vector3d first = Vector3d::Zero();
  double nodal = 0.0;  ///< Σ_k ∫ N_k dA: the area again

  explicit Moments(const GroupTrace& trace) {
    const auto& q = trace.quadrature;
    area = q.weights.sum();
    first = q.points * q.weights;
    xx = q.points.row(0).cwiseAbs2().dot(q.weights);
    Eigen::Index begin = 0;
    for (const auto& face : trace.faces) {
      const auto n = face.values->rows();
      nodal += (q.weights.segment(begin, n).transpose() * *face.values).sum();
      begin += n;
    }
  }
};

constexpr double kLength = 0.1, kWidth = 0.03;

/// A block whose top y = 0 is divided by bent lines, on no zone's edge.
Vector3d bent(const Vector3d& x) {
  const double pi = std::numbers::pi;
  return {kLength * (x[0] + 0.04 * std::sin(pi * x[0]) * std::cos(4.0 * x[2])),
          0.01 * (x[1] - 1.0),
          kWidth * (x[2] - 0.5 + 0.03 * std::sin(pi * x[2]) * x[0])};
}

template <int dim>
Moments within(const mesh::PartMesh<dim>& mesh, int degree, int group,
               const std::vector<HalfSpace>& bounds) {
  const auto discretization = discretize<dim>(mesh, degree);
  FaceTables<dim> tables;
  const WallFaces<dim> wall(discretization, {group}, tables);
  const ZoneTrace<dim> zone(wall, bounds);
  return Moments(zone.trace());
}

// A rectangle from x_1 to x_2 and z_1 to z_2, over cells that it cuts askew.
template <class Mesh>
void expect_rectangle(const Mesh& mesh, double tolerance) {
  const double x_1 = 0.0317, x_2 = 0.0533, z_1 = -0.0071, z_2 = 0.0098;
  const auto m = within<3>(mesh, 3, 3,
                           {{-Vector3d::UnitX(), -x_1},
                            {Vector3d::UnitX(), x_2},
                            {-Vector3d::UnitZ(), -z_1},
                            {Vector3d::UnitZ(), z_2}});
  const double area = (x_2 - x_1) * (z_2 - z_1);
  EXPECT_NEAR(m.area, area, tolerance * area);
  EXPECT_NEAR(m.nodal, area, tolerance * area);
  EXPECT_NEAR(m.first.x(), 0.5 * (x_1 + x_2) * area,
              tolerance * area * kLength);
  EXPECT_NEAR(m.first.z(), 0.5 * (z_1 + z_2) * area, tolerance * area * kWidth);
  EXPECT_NEAR(m.xx, (std::pow(x_2, 3) - std::pow(x_1, 3)) / 3.0 * (z_2 - z_1),
              tolerance * area * kLength * kLength);
}

TEST(ZoneTrace, RectangleOnStraightCellsIsExact) {
  expect_rectangle(
      support::structured_mesh<3>(
          {7, 2, 3}, 1,
          [](const Vector3d& x) -> Vector3d {
            return {kLength * x[0], 0.01 * (x[1] - 1.0), kWidth * (x[2] - 0.5)};
          }),
      1e-12);
}

// Chords of the cut's bent course in a cell; what they miss falls with the
// square of a cell.
TEST(ZoneTrace, RectangleOnBentCells) {
  expect_rectangle(support::structured_mesh<3>({7, 2, 3}, 3, bent), 1e-3);
  expect_rectangle(support::structured_mesh<3>({28, 2, 12}, 3, bent), 7e-5);
}

TEST(ZoneTrace, ObliqueEdgeOnTetrahedra) {
  const auto mesh =
      support::simplex_mesh<3>({5, 2, 3}, 1, [](const Vector3d& x) -> Vector3d {
        return {kLength * x[0], 0.01 * (x[1] - 1.0), kWidth * (x[2] - 0.5)};
      });
  expect_rectangle(mesh, 1e-12);
  // Below the line x + z = 0.06: a trapezium.
  const auto m = within<3>(
      mesh, 2, 3,
      {{Vector3d(1.0, 0.0, 1.0) / std::sqrt(2.0), 0.06 / std::sqrt(2.0)}});
  EXPECT_NEAR(m.area, 0.06 * kWidth, 1e-12 * m.area);
}

// A length of a bore, round all the way.
TEST(ZoneTrace, LengthOfABore) {
  auto mesh = support::sector_mesh<3>({.inner = 0.01,
                                       .outer = 0.03,
                                       .thickness = 0.05,
                                       .radial = 2,
                                       .angular = 3,
                                       .axial = 4});
  const auto m = within<3>(
      mesh, 3, 0, {{-Vector3d::UnitZ(), -0.0171}, {Vector3d::UnitZ(), 0.0303}});
  const double area = 0.01 * std::numbers::pi / 2.0 * (0.0303 - 0.0171);
  constexpr double kArc = 1e-6;  // of degree 4 over 30 deg
  EXPECT_NEAR(m.area, area, kArc * area);
  EXPECT_NEAR(m.first.z(), 0.5 * (0.0171 + 0.0303) * area, kArc * area);
}

// The side of a plate: cells are cut at one point, its thickness counts.
TEST(ZoneTrace, SideOfAPlate) {
  auto mesh = support::structured_mesh<2>(
      {7, 2}, 2, [](const Eigen::Vector2d& x) -> Eigen::Vector2d {
        return {kLength * (x[0] + 0.03 * std::sin(6.0 * x[0])),
                0.01 * (x[1] - 1.0)};
      });
  mesh.thickness = 0.008;
  const double end = kLength * (1.0 + 0.03 * std::sin(6.0));
  ASSERT_GT(end, 0.0533);
  const auto m = within<2>(
      mesh, 3, 3, {{-Vector3d::UnitX(), -0.0317}, {Vector3d::UnitX(), 0.0533}});
  const double length = 0.0533 - 0.0317;
  EXPECT_NEAR(m.area, length * 0.008, 1e-9 * m.area);
  EXPECT_NEAR(m.first.x(), 0.5 * (0.0533 + 0.0317) * m.area, 1e-9 * m.area);
}

}  // namespace
}  // namespace clevis::elasticity
