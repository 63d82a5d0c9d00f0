#include "mechanism/drives/drive_law.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace clevis::mechanism {
namespace {

DriveDefinition law(DriveLaw kind) {
  return {.law = kind,
          .from = 0.2,
          .to = 0.5,
          .start = 1.0,
          .duration = 2.0,
          .amplitude = 0.1,
          .frequency = 0.7,
          .place = "drive"};
}

TEST(DriveLaw, ConstantRests) {
  const DriveTarget q = drive_target(law(DriveLaw::kConstant), 1.7);
  EXPECT_EQ(q.position, 0.2);
  EXPECT_EQ(q.rate, 0.0);
  EXPECT_EQ(q.acceleration, 0.0);
}

TEST(DriveLaw, RampAndQuinticRestBeforeAndAfter) {
  for (const DriveLaw kind : {DriveLaw::kRamp, DriveLaw::kQuintic}) {
    EXPECT_EQ(drive_target(law(kind), 0.9).position, 0.2);
    EXPECT_EQ(drive_target(law(kind), 0.9).rate, 0.0);
    EXPECT_EQ(drive_target(law(kind), 3.1).position, 0.5);
    EXPECT_EQ(drive_target(law(kind), 3.1).rate, 0.0);
  }
}

TEST(DriveLaw, MiddleOfTheStrokeByHand) {
  EXPECT_NEAR(drive_target(law(DriveLaw::kRamp), 2.0).position, 0.35, 1e-15);
  EXPECT_NEAR(drive_target(law(DriveLaw::kRamp), 2.0).rate, 0.15, 1e-15);
  // quintic: 15/8 of the mean speed in the middle
  EXPECT_NEAR(drive_target(law(DriveLaw::kQuintic), 2.0).position, 0.35, 1e-15);
  EXPECT_NEAR(drive_target(law(DriveLaw::kQuintic), 2.0).rate, 0.15 * 1.875,
              1e-15);
  // and 10/√3 stroke/duration² where s = (1 − 1/√3)/2
  const double s = 0.5 * (1.0 - 1.0 / std::sqrt(3.0));
  EXPECT_NEAR(drive_target(law(DriveLaw::kQuintic), 1.0 + 2.0 * s).acceleration,
              10.0 / std::sqrt(3.0) * 0.3 / 4.0, 1e-14);
}

TEST(DriveLaw, SineStartsAtFrom) {
  const double omega = 2.0 * std::numbers::pi * 0.7;
  EXPECT_EQ(drive_target(law(DriveLaw::kSine), 0.5).rate, 0.0);
  const DriveTarget q = drive_target(law(DriveLaw::kSine), 1.4);
  EXPECT_NEAR(q.position, 0.2 + 0.1 * std::sin(omega * 0.4), 1e-15);
  EXPECT_NEAR(q.rate, 0.1 * omega * std::cos(omega * 0.4), 1e-14);
}

TEST(DriveLaw, SpeedRunsOnFromItsStart) {
  DriveDefinition drive = law(DriveLaw::kSpeed);
  drive.speed = -0.4;
  EXPECT_EQ(drive_target(drive, 0.9).position, 0.2);
  EXPECT_EQ(drive_target(drive, 0.9).rate, 0.0);
  const DriveTarget q = drive_target(drive, 11.0);  // beyond any duration
  EXPECT_NEAR(q.position, 0.2 - 0.4 * 10.0, 1e-14);
  EXPECT_EQ(q.rate, -0.4);
  EXPECT_EQ(q.acceleration, 0.0);
}

// Central differences of fourth order: error h⁴/30 times the fifth derivative
// (at most 720 stroke/duration⁵) plus round-off ε/h.
TEST(DriveLaw, DerivativesAreThoseOfThePosition) {
  constexpr double h = 1e-3, tolerance = 1e-9;
  for (const DriveLaw kind :
       {DriveLaw::kRamp, DriveLaw::kQuintic, DriveLaw::kSine}) {
    for (const double t : {1.3, 1.9, 2.6}) {
      const auto q = [&](double dt) {
        return drive_target(law(kind), t + dt);
      };
      const double rate = (8.0 * (q(h).position - q(-h).position) -
                           (q(2 * h).position - q(-2 * h).position)) /
                          (12.0 * h);
      const double acceleration =
          (8.0 * (q(h).rate - q(-h).rate) - (q(2 * h).rate - q(-2 * h).rate)) /
          (12.0 * h);
      EXPECT_NEAR(q(0.0).rate, rate, tolerance);
      EXPECT_NEAR(q(0.0).acceleration, acceleration, tolerance);
    }
  }
}

}  // namespace
}  // namespace clevis::mechanism
