// Driven motions whatever their instants: starts, ends and turns at change
// points, and what lies between instants.
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "mechanism/simulate.h"
#include "support/four_bar.h"

namespace clevis::mechanism {
namespace {

using namespace testing;

constexpr double kPi = std::numbers::pi;

/// A parallelogram of 2 m by 1 m, placed at `angle`, that a law drives.
MechanismDefinition parallelogram(double angle, const DriveDefinition& law) {
  MechanismDefinition m = four_bar(
      {.ground = 2.0, .crank = 1.0, .coupler = 2.0, .rocker = 1.0}, 0.5);
  m.bodies[0].placement.R_WL = m.bodies[2].placement.R_WL = turned(angle);
  m.bodies[1].placement.R_WL.setIdentity();
  m.bodies[1].placement.p_WL = m.bodies[0].placement.R_WL.col(0);
  m.drives = {law};
  return m;
}

DriveDefinition ramp(double from, double to, double duration = 1.0) {
  DriveDefinition drive;
  drive.law = DriveLaw::kRamp;
  drive.from = from;
  drive.to = to;
  drive.duration = duration;
  return drive;
}

DriveDefinition sine(double amplitude, double frequency) {
  DriveDefinition drive;
  drive.law = DriveLaw::kSine;
  drive.from = 0.5;
  drive.amplitude = amplitude;
  drive.frequency = frequency;
  return drive;
}

double tilt(const Instant& at) {
  return (at.bodies[1].pose.R_WL - Matrix3d::Identity()).norm();
}

std::string refusal(const MechanismDefinition& m,
                    const SimulationSettings& settings) {
  try {
    simulate(m, settings);
  } catch (const Error& error) {
    return fmt::format("{} {}", error.code(), error.problem());
  }
  return "";
}

const SimulationSettings kContinue{.duration = 1.0,
                                   .instants = 21,
                                   .at_singularity = AtSingularity::kContinue};

// An [[initial]] rate of the rocker decides at the start: with the crank, or
// crossed at −3 times its rate.
TEST(DrivenPath, StartsAtAChangePoint) {
  for (const double ratio : {1.0, -3.0}) {
    MechanismDefinition m = parallelogram(0.0, ramp(0.0, 1.0));
    m.initial_joints = {
        {.joint = 3, .position = {}, .rate = ratio, .place = "initial"}};
    const Motion motion = simulate(m, kContinue);
    ASSERT_EQ(motion.instants.size(), 21u);
    EXPECT_TRUE(motion.instants[0].is_change_point);
    EXPECT_FALSE(motion.instants[1].is_change_point);
    ASSERT_EQ(motion.change_points.size(), 1u);
    EXPECT_EQ(motion.change_points[0].t, 0.0);
    EXPECT_NEAR(motion.instants[0].bodies[2].w_WL.z(), ratio, 1e-7);
    if (ratio > 0.0) {
      for (const Instant& at : motion.instants) EXPECT_LT(tilt(at), 1e-9);
    } else {
      // the crossed one's rocker: (ψ − φ)/2 and (ψ + φ)/2 with
      // tan(ψ/2) = −3 tan(φ/2)
      const double rocker = 2.0 * std::atan(-3.0 * std::tan(0.5));
      const Matrix3d& R = motion.instants.back().bodies[2].pose.R_WL;
      EXPECT_NEAR(std::atan2(R(1, 0), R(0, 0)), rocker, 1e-9);
    }
  }
}

TEST(DrivenPath, AStartThatNothingDecidesIsRefused) {
  const auto m = parallelogram(0.0, ramp(0.0, 1.0));
  EXPECT_NE(refusal(m, kContinue).find("K010"), std::string::npos);
  EXPECT_NE(refusal(m, {.duration = 1.0}).find("K005"), std::string::npos);
}

TEST(DrivenPath, EndsAtAChangePoint) {
  for (const double to : {0.0, kPi}) {
    const auto m = parallelogram(0.5, ramp(0.5, to));
    const Motion motion = simulate(m, kContinue);
    ASSERT_EQ(motion.instants.size(), 21u);
    EXPECT_TRUE(motion.instants.back().is_change_point);
    ASSERT_EQ(motion.change_points.size(), 1u);
    EXPECT_EQ(motion.change_points[0].t, 1.0);
    EXPECT_LT(tilt(motion.instants.back()), 1e-9);
    EXPECT_NE(refusal(m, {.duration = 1.0, .instants = 21}).find("K005"),
              std::string::npos);
  }
}

// From 0.5 to exactly 0 and back: at 0.75 s, among the instants or not.
TEST(DrivenPath, TurnsAtAChangePoint) {
  for (const int instants : {21, 20}) {
    const auto m = parallelogram(0.5, sine(0.5, 1.0));
    SimulationSettings settings = kContinue;
    settings.instants = instants;
    const Motion motion = simulate(m, settings);
    ASSERT_EQ(motion.change_points.size(), 1u) << instants;
    EXPECT_NEAR(motion.change_points[0].t, 0.75, 1e-6);
    for (const Instant& at : motion.instants) EXPECT_LT(tilt(at), 1e-9);
  }
}

// One instant in a period, and twenty turns between three instants: the
// instants alone would show no motion at all.
TEST(DrivenPath, NothingIsSkippedBetweenInstants) {
  const auto swinging = parallelogram(0.5, sine(1.0, 10.0));
  EXPECT_EQ(simulate(swinging, {.duration = 1.0, .instants = 11})
                .change_points.size(),
            20u);
  const auto turning = parallelogram(0.5, ramp(0.5, 0.5 + 40.0 * kPi));
  const Motion motion = simulate(turning, {.duration = 1.0, .instants = 3});
  EXPECT_EQ(motion.change_points.size(), 40u);
  for (const Instant& at : motion.instants) EXPECT_LT(tilt(at), 1e-9);
}

// The crank of a four-bar with a + b < ... cannot turn beyond the angle at
// which coupler and rocker are in line: by the law of cosines.
TEST(DrivenPath, DeadEndsAreNamedExactly) {
  const FourBar l{.ground = 2.0, .crank = 1.2, .coupler = 1.0, .rocker = 1.0};
  const double reach = l.coupler + l.rocker;
  const double end =
      std::acos((l.ground * l.ground + l.crank * l.crank - reach * reach) /
                (2.0 * l.ground * l.crank));
  for (const int instants : {2, 7, 101}) {
    MechanismDefinition m = four_bar(l, 0.6);
    m.drives = {ramp(0.6, 2.0)};
    const std::string text =
        refusal(m, {.duration = 1.0, .instants = instants});
    ASSERT_NE(text.find("K004"), std::string::npos) << text;
    const auto number = [&text](const std::string& after) {
      return std::stod(text.substr(text.find(after) + after.size()));
    };
    EXPECT_NEAR(number("O at ") * kPi / 180.0, end, 1e-10) << text;
    EXPECT_NEAR(number("t = "), (end - 0.6) / 1.4, 1e-8) << text;
  }
  // a swing to it and back between two instants
  MechanismDefinition m = four_bar(l, 0.6);
  m.drives = {sine(0.8, 1.0)};
  m.drives[0].from = 0.6;
  EXPECT_NE(refusal(m, {.duration = 1.0, .instants = 2}).find("K004"),
            std::string::npos);
}

TEST(DrivenPath, MotionsWithoutEndAreRefused) {
  const auto m = parallelogram(0.5, ramp(0.5, 1e6));
  EXPECT_NE(refusal(m, {.duration = 1.0}).find("K008"), std::string::npos);
}

}  // namespace
}  // namespace clevis::mechanism
