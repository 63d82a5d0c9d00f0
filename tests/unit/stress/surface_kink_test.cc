#include "stress/surface/surface_kink.h"

#include <cmath>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

#include "elasticity/fe_space/tabulation.h"
#include "support/annulus_mesh.h"
#include "support/simplex_mesh.h"

namespace clevis::stress {
namespace {

using Eigen::Vector3d;

std::vector<int> all_cells(const mesh::PartMesh<3>& mesh) {
  std::vector<int> cells(mesh.cells.size());
  std::iota(cells.begin(), cells.end(), 0);
  return cells;
}

/// The same pressure or shear everywhere; xx, yy, zz, xy, yz, xz.
using Components = Eigen::Matrix<double, 1, 6>;

double kinked(const mesh::PartMesh<3>& mesh, const std::vector<int>& cells,
              const Components& stress) {
  const auto points = elasticity::lattice<3>(mesh.shape, 4).cols();
  return kinked_stress(
      mesh, cells,
      std::vector<Eigen::MatrixXd>(cells.size(), stress.replicate(points, 1)));
}

/// Of a unit pressure: the largest angle.
double largest_kink(const mesh::PartMesh<3>& mesh,
                    const std::vector<int>& cells) {
  return kinked(mesh, cells, {-1.0, -1.0, -1.0, 0.0, 0.0, 0.0});
}

/// A quarter of a ring, its geometry of some degree, in n cells around.
mesh::PartMesh<3> quarter(int degree, int n) {
  return support::simplex_mesh<3>(
      {1, n, 1}, degree, [](const Vector3d& x) -> Vector3d {
        const double angle = 0.5 * std::numbers::pi * x[1];
        return {(1.0 + x[0]) * std::cos(angle), (1.0 + x[0]) * std::sin(angle),
                x[2]};
      });
}

// Flat facets of 15° meet at 15°. A parabola through three points of an arc of
// half angle α leaves it at its ends with slope 2 tan(α/2) against its chord.
TEST(SurfaceKink, IsTheAngleThatTheFacetsLeave) {
  const auto flat = quarter(1, 6);
  EXPECT_NEAR(largest_kink(flat, all_cells(flat)), std::numbers::pi / 12, 1e-9);
  const double alpha = std::numbers::pi / 8;
  const auto parabolas = support::sector_mesh<3>(
      {.inner = 1, .outer = 2, .radial = 1, .angular = 2, .degree = 2});
  EXPECT_NEAR(largest_kink(parabolas, all_cells(parabolas)),
              2.0 * (alpha - std::atan(2.0 * std::tan(alpha / 2))), 1e-9);
}

TEST(SurfaceKink, IsNoneOnExactArcsAndAtTheEdgesOfThePart) {
  const auto exact = quarter(4, 3);
  EXPECT_LT(largest_kink(exact, all_cells(exact)), 1e-4);
  const auto block = support::structured_mesh<3>({2, 2, 2}, 1, [](auto& x) {
    return Vector3d(x);
  });
  EXPECT_LT(largest_kink(block, all_cells(block)), 1e-7);
}

// Tension along the edges does not cross them; a uniaxial one in the plane of
// the arc crosses by cos² of its angle with the facet, at best nearly whole.
TEST(SurfaceKink, CountsTheStressAcrossTheEdgeOnly) {
  const auto flat = quarter(1, 6);
  const double kink = std::numbers::pi / 12;
  EXPECT_LT(kinked(flat, all_cells(flat), {0.0, 0.0, 7.0, 0.0, 0.0, 0.0}),
            1e-9);
  const double across =
      kinked(flat, all_cells(flat), {7.0, 0.0, 0.0, 0.0, 0.0, 0.0});
  EXPECT_GT(across, 0.9 * 7.0 * kink);
  EXPECT_LE(across, 7.0 * kink * (1.0 + 1e-9));
}

// Only what touches the given cells.
TEST(SurfaceKink, FarAwayDoesNotCount) {
  const auto bar = support::structured_mesh<3>(
      {6, 1, 1}, 1, [](const Vector3d& x) -> Vector3d {
        return {x[0], x[1], x[2] + 0.3 * std::max(0.0, x[0] - 0.6)};
      });
  EXPECT_LT(largest_kink(bar, {0, 1}), 1e-7);
  EXPECT_GT(largest_kink(bar, {3, 4}), 0.1);
}

}  // namespace
}  // namespace clevis::stress
