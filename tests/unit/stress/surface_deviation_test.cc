#include "stress/surface/surface_deviation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/annulus_mesh.h"
#include "support/simplex_mesh.h"

namespace clevis::stress {
namespace {

using Eigen::Vector3d;

constexpr double kQuarter = 0.5 * std::numbers::pi;

/// A quarter of a ring of radii 1 and 2, 1 high, n cells around.
mesh::PartMesh<3> hexahedra(int degree, int n) {
  return support::sector_mesh<3>(
      {.inner = 1, .outer = 2, .radial = 1, .angular = n, .degree = degree});
}

mesh::PartMesh<3> tetrahedra(int degree, int n) {
  return support::simplex_mesh<3>(
      {1, n, 1}, degree, [](const Vector3d& x) -> Vector3d {
        const double angle = kQuarter * x[1];
        return {(1.0 + x[0]) * std::cos(angle), (1.0 + x[0]) * std::sin(angle),
                x[2]};
      });
}

double largest(const std::vector<double>& values) {
  return *std::ranges::max_element(values);
}

/// Mean distance of a polygon's side from its arc: area between over length.
double chord_deviation(double radius, double angle) {
  const double segment = 0.5 * radius * radius * (angle - std::sin(angle));
  return segment / (2.0 * radius * std::sin(0.5 * angle));
}

// At the ends of the quarter too, where a face has one neighbour alone.
TEST(SurfaceDeviation, IsThatOfChordsFromTheirArc) {
  const auto mesh = hexahedra(1, 9);
  const auto deviation = surface_deviation(mesh);
  const double wanted = chord_deviation(2.0, kQuarter / 9);
  for (const int cell : {0, 4, 8}) {
    double largest_of_cell = 0.0;
    for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
      if (mesh.boundary[f].cell != cell) continue;
      largest_of_cell = std::max(largest_of_cell, deviation[f]);
    }
    EXPECT_NEAR(largest_of_cell, wanted, 0.01 * wanted);
  }
}

// A parabola through three points of an arc: the area between them by
// Simpson's rule for the parabola, over the chord.
TEST(SurfaceDeviation, IsThatOfParabolasFromTheirArc) {
  const double angle = kQuarter / 3;
  const double sagitta = 2.0 * (1.0 - std::cos(0.5 * angle));
  const double chord = 4.0 * std::sin(0.5 * angle);
  const double segment = 2.0 * (angle - std::sin(angle));
  const double between = std::abs(segment - 2.0 / 3.0 * chord * sagitta);
  const double deviation = largest(surface_deviation(hexahedra(2, 3)));
  EXPECT_NEAR(deviation, between / chord, 0.1 * between / chord);
}

// Triangles that halve the quadrangles of a cylinder have one kink each. On one
// row of them the mean is over two edges, not three: half as much more.
TEST(SurfaceDeviation, OfTrianglesIsThatOfTheQuadranglesThatTheyHalve) {
  for (const int degree : {1, 2}) {
    const double of_quadrangles =
        largest(surface_deviation(hexahedra(degree, 5)));
    EXPECT_NEAR(largest(surface_deviation(tetrahedra(degree, 5))),
                1.5 * of_quadrangles, 0.01 * of_quadrangles)
        << degree;
  }
}

TEST(SurfaceDeviation, IsNoneOnFlatFacesAndExactArcs) {
  const auto block = support::structured_mesh<3>({2, 2, 2}, 1, [](auto& x) {
    return Vector3d(x);
  });
  EXPECT_LT(largest(surface_deviation(block)), 1e-9);
  EXPECT_LT(largest(surface_deviation(hexahedra(4, 3))), 1e-6);
}

// The same stress everywhere: volume over volume. The ring of chords lacks what
// stands under the outer arc and has too much at the inner one; ends have half.
TEST(EnergyBetween, IsTheVolumeBetweenIfTheStressIsUniform) {
  const int n = 9;
  const auto mesh = hexahedra(1, n);
  const double angle = kQuarter / n;
  const double segments = 0.5 * (1.0 + 4.0) * (angle - std::sin(angle));
  const double volume = n * 1.5 * std::sin(angle);
  const Eigen::MatrixXd stress = Eigen::MatrixXd::Constant(8, n, 3.0);
  const double share = energy_between(mesh, surface_deviation(mesh), stress);
  EXPECT_NEAR(share, n * segments / volume, 0.02 * share);
}

// Where no stress flows, no energy stands between.
TEST(EnergyBetween, IsWeightedByTheSquareOfTheStress) {
  const int n = 9;
  const auto mesh = hexahedra(1, n);
  Eigen::MatrixXd stress = Eigen::MatrixXd::Zero(8, n);
  stress.col(4).setConstant(2.0);
  const auto deviation = surface_deviation(mesh);
  const double alone = energy_between(mesh, deviation, stress);
  stress.col(5).setConstant(1.0);
  const double angle = kQuarter / n;
  const double segments = 0.5 * (1.0 + 4.0) * (angle - std::sin(angle));
  EXPECT_NEAR(alone, segments / (1.5 * std::sin(angle)), 0.02 * alone);
  EXPECT_NEAR(energy_between(mesh, deviation, stress), alone, 1e-3 * alone);
  EXPECT_EQ(energy_between(mesh, deviation, 0.0 * stress), 0.0);
}

}  // namespace
}  // namespace clevis::stress
