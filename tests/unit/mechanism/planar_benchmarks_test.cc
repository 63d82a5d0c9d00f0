// Planar mechanisms by which programs are compared against published values,
// and those values against formulations of their own.
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "mechanism/simulate.h"
#include "support/bricard_equations.h"
#include "support/crank_rocker_equations.h"
#include "support/governor_equations.h"
#include "support/planar_definition.h"
#include "support/planar_linkages.h"
#include "support/reference_motions.h"
#include "support/source_dir.h"

namespace clevis::mechanism {
namespace {

using Eigen::Vector3d;

/// Points by time [s] of a problem in reference_points.csv.
std::map<int, Vector3d> points_of(const std::string& problem) {
  std::ifstream file(support::source_dir() /
                     "tests/benchmarks/reference_points.csv");
  std::map<int, Vector3d> points;
  for (std::string row, cell; std::getline(file, row);) {
    std::stringstream cells(row);
    std::getline(cells, cell, ',');
    if (cell != problem) continue;
    std::array<double, 4> values{};
    for (double& value : values) {
      std::getline(cells, cell, ',');
      value = std::stod(cell);
    }
    points[static_cast<int>(std::lround(values[0]))] = {values[1], values[2],
                                                        values[3]};
  }
  return points;
}

// Thirteen digits stand in the file.
constexpr double kDigits = 1e-12;

TEST(ReferencePoints, FollowFromTheGovernorsEquations) {
  testing::GovernorEquations equations({});
  const auto points = points_of("governor");
  ASSERT_EQ(points.size(), 5u);
  for (const auto& [t, point] : points) {
    equations.advance(2.0, 400000);
    EXPECT_NEAR(point.z(), -equations.depth(), kDigits) << t;
  }
}

TEST(ReferencePoints, FollowFromBricardsClosedForm) {
  testing::BricardEquations equations;
  const auto points = points_of("bricard");
  ASSERT_EQ(points.size(), 10u);
  for (const auto& [t, point] : points) {
    equations.advance(1.0, 2000);
    EXPECT_LT((point - equations.corner()).norm(), kDigits) << t;
  }
}

TEST(ReferencePoints, FollowFromTheCrankRockersEquation) {
  testing::CrankRockerEquations equations({});
  const auto points = points_of("crank_rocker");
  ASSERT_EQ(points.size(), 10u);
  for (const auto& [t, point] : points) {
    if (t > 2) break;  // the rest would take long, and is clevis' below
    equations.advance(1.0, 80000);
    const Vector3d way(std::cos(equations.angle()), std::sin(equations.angle()),
                       0.0);
    EXPECT_LT((point - way).norm(), kDigits) << t;
  }
}

// Test Set for IVP Solvers; the forces at E are the multipliers there.
TEST(Andrews, MeetsTheTestSetAndItsForces) {
  const Motion motion = simulate(testing::definition_of(testing::andrews()),
                                 testing::sampled(0.03, 2, 1e-9));
  const Instant& end = motion.instants.back();
  const Vector3d crank = end.bodies[0].pose.R_WL.col(0);
  const double beta = 15.81077119515371, rate = 1139.920302259;
  EXPECT_NEAR(crank.x(), std::cos(beta), 2e-9);
  EXPECT_NEAR(crank.y(), std::sin(beta), 2e-9);
  EXPECT_NEAR(end.bodies[0].w_WL.z(), rate, 1e-6);
  const std::array<Eigen::Vector2d, 3> known = {
      Eigen::Vector2d(199.1753481045, -29.7553099750),
      Eigen::Vector2d(23.0665436116, 31.4527252758),
      Eigen::Vector2d(22.6424947864, 11.6173923526)};
  for (std::size_t k = 0; k < 3; ++k) {  // joints 7, 8, 9: E on K3, K4, K6
    EXPECT_NEAR(end.joints[7 + k].f_W.head<2>().norm(), known[k].norm(), 1e-7);
  }
}

// A cart without weight: the mass falls straight down, time and again.
TEST(LightCartPole, MeetsItsReference) {
  const Motion motion =
      simulate(testing::definition_of(testing::light_cart_pole()),
               testing::sampled(10.0, 2, 1e-9));
  const Instant& end = motion.instants.back();
  const double angle = -1.54912945718;  // from hanging down
  const Vector3d pole = end.bodies[1].pose.R_WL.col(0);
  EXPECT_NEAR(pole.x(), std::sin(angle), 1e-7);
  EXPECT_NEAR(pole.y(), -std::cos(angle), 1e-7);
  EXPECT_NEAR(end.bodies[0].pose.p_WL.x(), 1.99976328280, 1e-7);
}

TEST(CrankRocker, FollowsItsOwnEquation) {
  const Motion motion =
      simulate(testing::definition_of(testing::crank_rocker()),
               testing::sampled(10.0, 11, 1e-9));
  for (const auto& [t, point] : points_of("crank_rocker")) {
    const Instant& at = motion.instants[static_cast<std::size_t>(t)];
    EXPECT_LT((at.bodies[0].pose.R_WL.col(0) - point).norm(), 1e-7) << t;
  }
}

}  // namespace
}  // namespace clevis::mechanism
