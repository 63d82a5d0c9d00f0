// The landing gear with DD1 = 190 mm passes the change point of its
// parallelogram ABCD near lx = 163.07 mm, where AB and DC stand upright.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "base/errors.h"
#include "mechanism/simulate.h"
#include "support/landing_gear.h"

namespace clevis::mechanism {
namespace {

using namespace testing;

/// Cylinder length where DC is upright, by bisection of the closed form.
double change_point_length(double DD1) {
  double low = 0.155, high = 0.2;  // theta > 90 and < 90 degrees
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (landing_gear_angles(middle, DD1).theta > 0.5 * std::numbers::pi ? low
                                                                     : high) =
        middle;
  }
  return low;
}

/// |BC − parallelogram position| [m]: 0 on the branch of the placement.
double off_branch(const Instant& at) {
  const Vector3d BC = at.joints[kB].p_WJ - at.joints[kC].p_WJ;
  return (BC - Vector3d(0.0, -kBC, 0.0)).norm();
}

TEST(ChangePoint, LengthOfTheReference) {
  EXPECT_NEAR(1e3 * change_point_length(0.190), 163.07, 0.0051);
}

TEST(ChangePoint, MotionContinuesOnItsBranch) {
  for (const int instants : {201, 57, 8}) {
    const Motion motion =
        simulate(landing_gear(0.190), {.duration = 2.0, .instants = instants});
    for (const Instant& at : motion.instants) {
      EXPECT_LT(off_branch(at), 1e-9);
    }
    ASSERT_EQ(motion.change_points.size(), 1u);
    const auto at_time = [&motion](double t) {
      return *std::ranges::find(motion.instants, t, &Instant::t);
    };
    const ChangePoint& point = motion.change_points[0];
    EXPECT_LT(at_time(point.t_before).drives[0].position,
              change_point_length(0.190));
    EXPECT_GT(at_time(point.t_after).drives[0].position,
              change_point_length(0.190));
  }
}

TEST(ChangePoint, RegularStrokePassesNone) {
  EXPECT_TRUE(
      simulate(landing_gear(), {.duration = 2.0}).change_points.empty());
}

// The force in AB grows like 1/distance: halving it doubles the force.
TEST(ChangePoint, ReactionsGrowWithoutBound) {
  const double l0 = change_point_length(0.190);
  const auto force = [l0](double distance) {
    MechanismDefinition m = landing_gear(0.190, l0 + distance);
    hold(m, l0 + distance);
    m.forces = {wheel_load(0.14)};
    return simulate(m, {.duration = 1.0, .instants = 1})
        .instants[0]
        .joints[kA]
        .f_W.norm();
  };
  EXPECT_NEAR(force(1e-4) / force(2e-4), 2.0, 0.02);
}

TEST(ChangePoint, ExactlyThereIsRefused) {
  const double l0 = change_point_length(0.190);
  MechanismDefinition m = landing_gear(0.190);
  m.drives[0].law = DriveLaw::kRamp;
  m.drives[0].to = 2.0 * l0 - m.drives[0].from;  // half-way at t = 1 s
  try {
    simulate(m, {.duration = 2.0, .instants = 21});
    FAIL() << "passed the change point with finite reactions";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "K005");
    EXPECT_NE(error.problem().find("t = 1 s"), std::string::npos)
        << error.problem();
  }
  hold(m, l0);
  EXPECT_THROW(simulate(m, {.duration = 1.0, .instants = 1}), Error);
}

}  // namespace
}  // namespace clevis::mechanism
