#include "stress/surface_kink.h"

#include <cmath>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

#include "support/annulus_mesh.h"
#include "support/simplex_mesh.h"

namespace clevis::stress {
namespace {

using Eigen::Vector3d;

template <class Mesh>
std::vector<int> all_cells(const Mesh& mesh) {
  std::vector<int> cells(mesh.cells.size());
  std::iota(cells.begin(), cells.end(), 0);
  return cells;
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
