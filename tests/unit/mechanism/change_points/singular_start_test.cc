// Motions that start where branches of positions meet.
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "mechanism/simulate.h"
#include "support/four_bar.h"
#include "support/free_linkages.h"

namespace clevis::mechanism {
namespace {

using namespace testing;

constexpr double kG = 9.81;

/// The two windows with all uprights at `angle`; rates of uprights 0, 1, ….
MechanismDefinition windows_at(double angle, const std::vector<double>& rates) {
  MechanismDefinition m = two_window_four_bar();
  const Vector3d up(std::cos(angle), std::sin(angle), 0.0);
  for (std::size_t i = 0; i < 3; ++i) {
    m.bodies[i].placement.R_WL = turned(angle);
  }
  for (std::size_t i = 0; i < 2; ++i) {
    m.bodies[3 + i].placement.p_WL =
        up + static_cast<double>(i) * Vector3d::UnitX();
  }
  m.initial_joints.clear();
  for (std::size_t i = 0; i < rates.size(); ++i) {
    m.initial_joints.push_back({.joint = static_cast<int>(i),
                                .position = {},
                                .rate = rates[i],
                                .place = "initial"});
  }
  return m;
}

/// Of the parallelograms, energy 3/2 w² + 7/2 g sin: from upright at 1 rad/s.
double speed(double angle) {
  return std::sqrt(1.0 + 7.0 / 3.0 * kG * (1.0 - std::sin(angle)));
}

/// Time from upright to `angle` below it, by Simpson's rule.
double time_to(double angle) {
  constexpr int n = 4000;
  const double up = 0.5 * std::numbers::pi, h = (angle - up) / n;
  double sum = 1.0 / speed(up) + 1.0 / speed(angle);
  for (int i = 1; i < n; ++i) {
    sum += (i % 2 == 1 ? 4.0 : 2.0) / speed(up + i * h);
  }
  return std::abs(sum * h / 3.0);
}

double worst_branch(const Motion& motion) {
  double worst = 0.0;
  for (const Instant& at : motion.instants) {
    for (const std::size_t k : {1u, 2u}) {
      worst = std::max(
          worst, (at.bodies[k].pose.R_WL - at.bodies[0].pose.R_WL).norm());
    }
  }
  return worst;
}

TEST(SingularStart, TimeOfTheReference) {
  EXPECT_NEAR(time_to(0.0), 0.7143555293, 6e-11);
}

// Started on its way, the mechanism must be at 5 s and 10 s where the
// reference is, which started upright. At 0° one rate fits one branch alone; at
// −180° three are needed.
TEST(SingularStart, ReachesTheReferenceFromBothEnds) {
  for (const double beside : {0.0, 1e-12, -1e-12, 1e-7}) {
    for (const double end : {0.0, -std::numbers::pi}) {
      const double angle = end + beside;
      std::vector<double> rates(end == 0.0 ? 1 : 3, -speed(angle));
      const double t0 = time_to(angle);
      for (const double t : {5.0, 10.0}) {
        const Motion motion =
            simulate(windows_at(angle, rates),
                     {.duration = t - t0, .instants = 41, .tolerance = 1e-9});
        EXPECT_LT(worst_branch(motion), 1e-8) << angle;
        EXPECT_LT(motion.integration->relative_energy_error, 1e-8) << angle;
        const Pose& pose = motion.instants.back().bodies[0].pose;
        const Vector3d expected =
            t == 5.0 ? Vector3d(-0.811310461004, -0.584615545351, 0.0)
                     : Vector3d(0.328458111539, 0.944518538179, 0.0);
        EXPECT_LT((pose.R_WL.col(0) - expected).norm(), 1e-7) << angle;
      }
    }
  }
}

std::string refusal(const MechanismDefinition& m) {
  try {
    simulate(m, {.duration = 1.0, .instants = 3});
  } catch (const Error& error) {
    return fmt::format("{} {} {}", error.code(), error.problem(),
                       error.remedy());
  }
  return "";
}

TEST(SingularStart, RatesThatFitSeveralBranchesAreRefused) {
  const std::string text = refusal(windows_at(std::numbers::pi, {4.0}));
  EXPECT_NE(text.find("K010"), std::string::npos) << text;
  EXPECT_NE(text.find("A1 ("), std::string::npos) << text;
}

TEST(SingularStart, AtRestIsRefused) {
  const std::string text = refusal(windows_at(0.0, {0.0}));
  EXPECT_NE(text.find("K010"), std::string::npos) << text;
}

/// A flat parallelogram of 2 m by 1 m, no gravity.
MechanismDefinition flat(double angle, double crank, double rocker) {
  MechanismDefinition m = four_bar(
      {.ground = 2.0, .crank = 1.0, .coupler = 2.0, .rocker = 1.0}, 0.5);
  m.drives.clear();
  m.gravity_W.setZero();
  m.bodies[0].placement.R_WL = m.bodies[2].placement.R_WL = turned(angle);
  m.bodies[1].placement.R_WL.setIdentity();
  m.bodies[1].placement.p_WL = m.bodies[0].placement.R_WL.col(0);
  m.initial_joints = {
      {.joint = 0, .position = {}, .rate = crank, .place = "crank"},
      {.joint = 3, .position = {}, .rate = rocker, .place = "rocker"}};
  return m;
}

// The coupler keeps its length if (d − a)(d + 3 a) = 0 for the rates a of the
// crank, d of the rocker: parallelogram, or crossed.
TEST(SingularStart, TheRatesSingleOutABranch) {
  for (const double rocker : {1.0, -3.0}) {
    const Motion motion =
        simulate(flat(0.0, 1.0, rocker), {.duration = 0.5, .tolerance = 1e-9});
    EXPECT_LT(motion.integration->relative_energy_error, 1e-8);
    for (const Instant& at : motion.instants) {
      const double turn =
          (at.bodies[1].pose.R_WL - Matrix3d::Identity()).norm();
      if (rocker == 1.0) {
        EXPECT_LT(turn, 1e-8);
      } else if (at.t > 0.1) {
        EXPECT_GT(turn, 0.05);
      }
    }
  }
}

TEST(SingularStart, RatesOfNoBranchAreRefused) {
  for (const double rocker : {3.0, 0.0, 1.01}) {
    const std::string text = refusal(flat(0.0, 1.0, rocker));
    EXPECT_NE(text.find("K007"), std::string::npos) << rocker << text;
  }
}

// 1e-3 degrees beside, inside the rank's threshold: the position tells the
// branch.
TEST(SingularStart, ThePositionBesideTellsTheBranch) {
  MechanismDefinition m = flat(1e-3 * std::numbers::pi / 180.0, 1.0, 1.0);
  m.initial_joints.pop_back();
  const Motion motion = simulate(m, {.duration = 0.5, .tolerance = 1e-9});
  for (const Instant& at : motion.instants) {
    EXPECT_LT((at.bodies[1].pose.R_WL - Matrix3d::Identity()).norm(), 1e-8);
  }
  EXPECT_LT(motion.integration->relative_energy_error, 1e-8);
}

// In space the same loop has three rows too many: left null vectors that do
// not tell branches.
TEST(SingularStart, AmongRedundantConstraints) {
  MechanismDefinition m = flat(0.0, 1.0, -3.0);
  m.dimension = SpaceDimension::kSpatial;
  const Motion space = simulate(m, {.duration = 0.5, .instants = 6});
  const Motion plane =
      simulate(flat(0.0, 1.0, -3.0), {.duration = 0.5, .instants = 6});
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_LT((space.instants[i].bodies[2].pose.R_WL -
               plane.instants[i].bodies[2].pose.R_WL)
                  .norm(),
              1e-8);
  }
}

// Drives fix the motion: what [[initial]] says must agree with them.
TEST(SingularStart, InitialRatesThatContradictTheDriveAreRefused) {
  MechanismDefinition m = four_bar({}, 0.5);
  const double rate = 4.0 * std::numbers::pi;
  m.initial_joints = {
      {.joint = 0, .position = 0.5, .rate = rate, .place = "i"}};
  EXPECT_EQ(refusal(m), "");
  m.initial_joints[0].rate = 1.001 * rate;
  EXPECT_NE(refusal(m).find("K007"), std::string::npos);
  m.initial_joints[0] = {
      .joint = 0, .position = 0.51, .rate = {}, .place = "i"};
  EXPECT_NE(refusal(m).find("K007"), std::string::npos);
  m.initial_joints.clear();
  m.initial_bodies = {{.body = 2, .w_WL = {0.0, 0.0, 1.0}, .place = "body"}};
  EXPECT_NE(refusal(m).find("K007"), std::string::npos);
}

}  // namespace
}  // namespace clevis::mechanism
