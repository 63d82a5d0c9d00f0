#include "stress/corners/round_surfaces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "support/annulus_mesh.h"

namespace clevis::stress {
namespace {

using Eigen::Vector3d;

/// Five facets: their middles stand 19 % of the radius inside the circle, and
/// the circle's points there 62 % of it away from the next vertex.
template <int dim>
std::vector<RoundSurface> coarse_bore() {
  return round_surfaces(support::ring_mesh<dim>(
      {.inner = 0.01, .outer = 0.02, .radial = 1, .angular = 5, .degree = 1}));
}

double nearest(const RoundSurface& round, const Vector3d& from) {
  double result = std::numeric_limits<double>::max();
  for (const Vector3d& point : round.points) {
    result = std::min(result, (point - from).norm());
  }
  return result;
}

template <int dim>
void expect_distance_of_the_cylinder(double z) {
  const auto rounds = coarse_bore<dim>();
  ASSERT_EQ(rounds.size(), 1u);
  EXPECT_EQ(rounds[0].vertices.size(), dim == 2 ? 5u : 10u);
  for (const Vector3d& point : rounds[0].points) {
    EXPECT_NEAR(point.head<2>().norm(), 0.01, 1e-12);
  }
  for (double angle = 0.0; angle < 2.0 * std::numbers::pi; angle += 0.05) {
    const Vector3d from(0.014 * std::cos(angle), 0.014 * std::sin(angle), z);
    EXPECT_NEAR(nearest(rounds[0], from), 0.004, 0.04 * 0.004) << angle;
  }
}

TEST(RoundSurfaces, DistanceIsThatOfTheCylinderHoweverCoarseTheMesh) {
  expect_distance_of_the_cylinder<2>(0.0);
  expect_distance_of_the_cylinder<3>(0.0);
}

TEST(RoundSurfaces, MeshWithoutRoundGroupsHasNone) {
  auto mesh = support::ring_mesh<2>(
      {.inner = 0.01, .outer = 0.02, .radial = 1, .angular = 5, .degree = 1});
  for (auto& group : mesh.groups) group.cylinder.reset();
  EXPECT_TRUE(round_surfaces(mesh).empty());
}

}  // namespace
}  // namespace clevis::stress
