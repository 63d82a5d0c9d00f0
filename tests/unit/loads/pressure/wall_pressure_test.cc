// Pressure of a rigid block on flat walls, against the statics of a strip.
#include "loads/pressure/wall_pressure.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace clevis::loads {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr double kLength = 0.02, kWidth = 0.008, kGap = 0.01;  // [m]

/// Walls y = 0 (part below, outward +y) and, if wanted, y = kGap (outward −y),
/// x from −l/2 to l/2, z over the width, by midpoints.
struct Walls {
  GroupQuadrature quadrature;
  Matrix3Xd outward;
};

Walls walls(bool both, Index along = 2000, Index across = 4) {
  const Index n = along * across;
  Walls result;
  result.quadrature.points.resize(3, both ? 2 * n : n);
  result.quadrature.weights =
      Eigen::VectorXd::Constant(result.quadrature.points.cols(),
                                kLength * kWidth / static_cast<double>(n));
  result.outward.resize(3, result.quadrature.points.cols());
  for (Index q = 0; q < result.outward.cols(); ++q) {
    const Index k = q % n;
    const double x =
        (static_cast<double>(k % along) + 0.5) / static_cast<double>(along) -
        0.5;
    const double z =
        (static_cast<double>(k / along) + 0.5) / static_cast<double>(across) -
        0.5;
    const bool upper = q >= n;
    result.quadrature.points.col(q) =
        Vector3d(x * kLength, upper ? kGap : 0.0, z * kWidth);
    result.outward.col(q) = Vector3d(0.0, upper ? -1.0 : 1.0, 0.0);
  }
  return result;
}

/// A force −N ŷ on the lower wall at a distance e from the middle.
Wrench pressed(double force, double e) {
  return {.force = {0.0, -force, 0.0}, .moment = {0.0, 0.0, -force * e}};
}

// Navier: p = N/(l w) (1 + 12 e x/l²) while |e| <= l/6.
TEST(WallPressure, IsLinearWithinTheMiddleThird) {
  const Walls w = walls(false);
  const double e = kLength / 8.0, force = 1000.0;
  const auto t = wall_pressure(w.quadrature, w.outward, pressed(force, e),
                               Vector3d::Zero());
  ASSERT_TRUE(t);
  for (Index q = 0; q < t->cols(); ++q) {
    const double x = w.quadrature.points(0, q);
    const double p =
        force / (kLength * kWidth) * (1.0 + 12.0 * e * x / (kLength * kLength));
    ASSERT_NEAR((*t)(1, q), -p, 1e-5 * force / (kLength * kWidth));
  }
}

// Beyond it a wall that cannot pull is touched over 3 (l/2 − e), with
// p = 2 N/(3 (l/2 − e) w) at the edge.
TEST(WallPressure, LiftsOffBeyondTheMiddleThird) {
  const Walls w = walls(false);
  const double e = 0.35 * kLength, force = 1000.0;
  const auto t = wall_pressure(w.quadrature, w.outward, pressed(force, e),
                               Vector3d::Zero());
  ASSERT_TRUE(t);
  const double touched = 3.0 * (0.5 * kLength - e);
  const double largest = 2.0 * force / (touched * kWidth);
  EXPECT_NEAR(-t->row(1).minCoeff(), largest, 2e-3 * largest);
  for (Index q = 0; q < t->cols(); ++q) {
    const double x = w.quadrature.points(0, q);
    const double p =
        largest * std::max(0.0, 1.0 - (0.5 * kLength - x) / touched);
    ASSERT_NEAR((*t)(1, q), -p, 2e-3 * largest) << x;
  }
}

// Two walls: σ = N/(l w) + 12 M x/(l³ w), its positive part on the one, the
// rest on the other.
TEST(WallPressure, TiltPressesAtTwoEndsOnOppositeWalls) {
  const Walls w = walls(true);
  const double moment = 10.0, force = 300.0;
  const Wrench wrench{.force = {0.0, -force, 0.0},
                      .moment = {0.0, 0.0, -moment}};
  const auto t =
      wall_pressure(w.quadrature, w.outward, wrench, Vector3d::Zero());
  ASSERT_TRUE(t);
  const double scale = 6.0 * moment / (kLength * kLength * kWidth);
  for (Index q = 0; q < t->cols(); ++q) {
    const double x = w.quadrature.points(0, q);
    const double sigma = force / (kLength * kWidth) +
                         12.0 * moment * x / (std::pow(kLength, 3) * kWidth);
    const bool upper = w.outward(1, q) < 0.0;
    const double wanted = upper ? std::max(0.0, -sigma) : -std::max(0.0, sigma);
    ASSERT_NEAR((*t)(1, q), wanted, 1e-5 * scale) << x << " " << upper;
  }
}

TEST(WallPressure, ResultantIsWhatWallsCanCarry) {
  const Walls w = walls(true, 60, 20);
  const Wrench wrench{.force = {50.0, -300.0, 20.0},
                      .moment = {0.4, 0.7, -3.0}};
  const Vector3d about(0.003, 0.5 * kGap, -0.001);
  const auto t = wall_pressure(w.quadrature, w.outward, wrench, about);
  ASSERT_TRUE(t);
  // In the middle between the walls forces along them have no other arm.
  const Vector3d middle(0.0, 0.5 * kGap, 0.0);
  const Wrench reached = resultant(w.quadrature, *t, middle);
  const Vector3d moment = wrench.moment + (about - middle).cross(wrench.force);
  EXPECT_NEAR(reached.force.y(), wrench.force.y(), 1e-7);
  EXPECT_NEAR(reached.force.x(), 0.0, 1e-9);
  EXPECT_NEAR(reached.moment.x(), moment.x(), 1e-9);
  EXPECT_NEAR(reached.moment.z(), moment.z(), 1e-9);
  EXPECT_NEAR(reached.moment.y(), 0.0, 1e-9);
  EXPECT_LE((t->cwiseProduct(w.outward)).colwise().sum().maxCoeff(), 0.0);
}

TEST(WallPressure, AWallCannotPull) {
  const Walls w = walls(false, 50, 4);
  const auto taken = [&](const Wrench& wrench) {
    return wall_pressure(w.quadrature, w.outward, wrench, Vector3d::Zero())
        .has_value();
  };
  EXPECT_FALSE(taken(pressed(-1000.0, 0.0)));
  EXPECT_FALSE(taken(pressed(1000.0, 0.6 * kLength)));  // beyond the edge
  EXPECT_FALSE(taken({.moment = {0.0, 0.0, 5.0}}));
  EXPECT_TRUE(taken(pressed(1000.0, 0.4 * kLength)));
}

// Whatever the force's place on a wall: pressed within its edges it is taken,
// beyond them not, and the resultant is the wrench.
TEST(WallPressure, EveryPlaceWithinTheEdgesIsTaken) {
  for (int k = 0; k < 400; ++k) {
    const Walls w = walls(false, 40 + k % 37, 6);
    const double e = (k % 101 - 50) / 50.0 * 0.6 * kLength;
    const double z = (k % 17 - 8) / 8.0 * 0.1 * kWidth;
    const Wrench wrench{.force = {0.0, -200.0, 0.0},
                        .moment = {200.0 * z, 0.0, -200.0 * e}};
    const auto t =
        wall_pressure(w.quadrature, w.outward, wrench, Vector3d::Zero());
    if (std::abs(std::abs(e) - 0.5 * kLength) < 0.06 * kLength) continue;
    ASSERT_EQ(t.has_value(), std::abs(e) < 0.5 * kLength) << k << " " << e;
    if (!t) continue;
    const Wrench reached = resultant(w.quadrature, *t, Vector3d::Zero());
    ASSERT_LT((reached.force - wrench.force).norm(), 1e-7) << k;
    ASSERT_LT((reached.moment - wrench.moment).norm(), 1e-9) << k;
  }
}

// Four walls of a square bore take a force across any direction.
TEST(WallPressure, SquareBoreTakesObliqueForces) {
  constexpr Index kPoints = 21;
  Walls w;
  w.quadrature.points.resize(3, 4 * kPoints);
  w.quadrature.weights = Eigen::VectorXd::Constant(4 * kPoints, 1e-6);
  w.outward.resize(3, 4 * kPoints);
  for (Index q = 0; q < 4 * kPoints; ++q) {
    const double x = (static_cast<double>(q % kPoints) - 10.0) * 1e-3;
    const double angle = static_cast<double>(q / kPoints) * M_PI / 2.0;
    const Vector3d away(0.0, std::cos(angle), std::sin(angle));
    w.quadrature.points.col(q) = x * Vector3d::UnitX() + 5e-3 * away;
    w.outward.col(q) = -away;  // the part is outside
  }
  const Wrench wrench{.force = {0.0, 300.0, -400.0}, .moment = {0, 0, 0}};
  const auto t =
      wall_pressure(w.quadrature, w.outward, wrench, Vector3d::Zero());
  ASSERT_TRUE(t);
  const Wrench reached = resultant(w.quadrature, *t, Vector3d::Zero());
  EXPECT_LT((reached.force - wrench.force).norm(), 1e-7);
  EXPECT_LT(reached.moment.norm(), 1e-9);
}

}  // namespace
}  // namespace clevis::loads
