// Points of a part in the cells that hold them.

#include "stress/field/probe.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "elasticity/fe_space/discretization.h"
#include "support/simplex_mesh.h"

namespace clevis::stress {
namespace {

using Eigen::Vector3d;

constexpr double kRadius = 0.02;

/// A quarter of a ring of radii 10 and 20 mm, in cells of 45 degrees.
elasticity::Discretization<3> ring(int degree) {
  return elasticity::discretize<3>(
      support::simplex_mesh<3>(
          {2, 1, 1}, 2,
          [](const Vector3d& x) -> Vector3d {
            const double angle = 0.5 * std::numbers::pi * (1.0 - x.x());
            const double r = 0.5 * kRadius * (1.0 + x.y());
            return {r * std::cos(angle), r * std::sin(angle), 0.01 * x.z()};
          }),
      degree);
}

Vector3d on_wall(double degrees, double off) {
  const double angle = degrees * std::numbers::pi / 180.0;
  return {(kRadius + off) * std::cos(angle), (kRadius + off) * std::sin(angle),
          0.004};
}

TEST(Probe, StandsOnACurvedWall) {
  constexpr double kNone = 0.0, kChord = 0.1, kCurved = 2e-3;
  const auto straight = ring(1), curved = ring(2);
  for (const double at : {10.0, 22.5, 60.0}) {
    // A chord of 45 degrees is 1.5 mm inside of its arc.
    for (const double off : {0.0, -5e-4}) {
      EXPECT_TRUE(locate(straight, on_wall(at, off), kNone).empty()) << at;
      EXPECT_TRUE(locate(straight, on_wall(at, off), kCurved).empty()) << at;
      const auto found = locate(straight, on_wall(at, off), kChord);
      ASSERT_EQ(found.size(), 1U) << at;
      const Eigen::Vector3d xi = found[0].second;
      EXPECT_GE(xi.minCoeff(), 0.0);
      EXPECT_LE(xi.sum(), 1.0 + 1e-12);
    }
    EXPECT_FALSE(locate(curved, on_wall(at, 0.0), kCurved).empty()) << at;
    EXPECT_FALSE(locate(curved, on_wall(at, -5e-4), kNone).empty()) << at;
    for (const auto* ring : {&straight, &curved}) {
      EXPECT_TRUE(locate(*ring, on_wall(at, 4e-3), kChord).empty()) << at;
    }
  }
}

}  // namespace
}  // namespace clevis::stress
