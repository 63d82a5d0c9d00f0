// The landing gear with DD1 = 190 mm passes the change point of its
// parallelogram ABCD near lx = 163.07 mm, where AB and DC stand upright.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "mechanism/simulate.h"
#include "support/four_bar.h"
#include "support/free_linkages.h"

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
    m.elements = {wheel_load(0.14)};
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

TEST(ChangePoint, IsLocated) {
  for (const int instants : {201, 57, 8}) {
    const Motion motion =
        simulate(landing_gear(0.190), {.duration = 2.0, .instants = instants});
    ASSERT_EQ(motion.change_points.size(), 1u);
    ASSERT_TRUE(motion.change_points[0].at);
    EXPECT_NEAR(motion.change_points[0].at->drives[0].position,
                change_point_length(0.190), 2e-6);  // rank threshold 3e-5
    EXPECT_LT(off_branch(*motion.change_points[0].at), 1e-9);
  }
}

/// A parallelogram of 2 m by 1 m whose crank turns through the line of its
/// pins while 3 N pull hinge Q of coupler and rocker across.
MechanismDefinition flat_parallelogram(double compliance) {
  FourBar l{.ground = 2.0, .crank = 1.0, .coupler = 2.0, .rocker = 1.0};
  MechanismDefinition m = four_bar(l, 0.5);
  m.gravity_W = Vector3d::Zero();
  m.drives[0].law = DriveLaw::kQuintic;
  m.drives[0].from = 0.5;
  m.drives[0].to = -0.5;
  m.drives[0].duration = 2.0;
  const double angles[] = {0.5, 0.0, 0.5};
  for (std::size_t i = 0; i < 3; ++i) {
    m.bodies[i].mass_properties.mass *= 1e-9;
    m.bodies[i].mass_properties.inertia_LCm *= 1e-9;
    m.bodies[i].placement.R_WL = turned(angles[i]);
  }
  for (JointDefinition& joint : m.joints) {
    joint.compliance = {Vector3d::Constant(compliance),
                        Vector3d::Constant(compliance)};
  }
  ConstantForce force;
  force.name = "across";
  force.point = {1, {2.0, 0.0, 0.0}};  // hinge Q
  force.f_W = {0.0, -3.0, 0.0};
  m.elements = {force};
  return m;
}

// O (0, 0), P (1, 0), G (2, 0), Q (3, 0). Q moves w across and u back: the
// rocker wants w²/2 − u more, the coupler w²/4 − u; they carry ±T against
// 4 c, all pins in a row: T = w²/(16 c). Across: 3 N = T w − T w/2.
TEST(ChangePoint, CompliantForcesOfTwoBarsInLine) {
  for (const double c : {8e-9, 1e-9, 1e-11}) {
    const Motion motion =
        simulate(flat_parallelogram(c), {.duration = 2.0, .instants = 12});
    ASSERT_EQ(motion.change_points.size(), 1u);
    ASSERT_TRUE(motion.change_points[0].at);
    const Instant& at = *motion.change_points[0].at;
    EXPECT_NEAR(at.drives[0].position, 0.0, 2e-4);
    const double T = std::cbrt(9.0 / (4.0 * c));
    for (const JointReaction& r : at.joints) {
      // left out: w² against 1, and how far the located point is off
      EXPECT_NEAR(r.f_W.norm(), T, 0.02 * T) << c;
    }
  }
}

TEST(ChangePoint, ExactlyThereWithContinue) {
  const double l0 = change_point_length(0.190);
  MechanismDefinition m = landing_gear(0.190);
  m.elements = {wheel_load(0.14)};
  m.drives[0].law = DriveLaw::kRamp;
  m.drives[0].to = 2.0 * l0 - m.drives[0].from;  // half-way at t = 1 s
  const Motion motion =
      simulate(m, {.duration = 2.0,
                   .instants = 21,
                   .at_singularity = AtSingularity::kContinue});
  ASSERT_EQ(motion.instants.size(), 21u);
  ASSERT_EQ(motion.change_points.size(), 1u);
  const Instant& at = motion.instants[10];
  EXPECT_TRUE(at.is_change_point);
  EXPECT_FALSE(motion.instants[9].is_change_point);
  EXPECT_LT(off_branch(at), 1e-9);
  const double force = at.joints[kA].f_W.norm();
  // less than what rigid joints would carry 0.3 mm beside it
  EXPECT_GT(force, 5e3);
  EXPECT_LT(force, motion.instants[9].joints[kA].f_W.norm());
  // velocities are those of the branch: between their neighbours
  const double w = at.bodies[kBodyAB].w_WL.z();
  EXPECT_NEAR(w,
              0.5 * (motion.instants[9].bodies[kBodyAB].w_WL.z() +
                     motion.instants[11].bodies[kBodyAB].w_WL.z()),
              1e-3 * std::abs(w));
  for (const Instant& instant : motion.instants) {
    EXPECT_LT(off_branch(instant), 1e-9);
  }
}

/// The two windows, or the first alone, turned by ten half turns in 10 s.
MechanismDefinition windows(int count) {
  MechanismDefinition m = two_window_four_bar();
  if (count == 1) {
    m.joints = {m.joints[0], m.joints[1], m.joints[3], m.joints[4]};
    m.joints[2].body_b = m.joints[3].body_b = 2;
    m.bodies = {m.bodies[0], m.bodies[1], m.bodies[3]};
  }
  m.initial_joints.clear();
  DriveDefinition drive;
  drive.law = DriveLaw::kRamp;
  drive.from = 0.5 * std::numbers::pi;
  drive.to = 10.5 * std::numbers::pi;
  drive.duration = 10.0;
  m.drives = {drive};
  return m;
}

// Both loops lose rank together: det J does not change its sign.
TEST(ChangePoint, TenTimesWithTwoWindows) {
  for (const int instants : {202, 1000, 38}) {
    const MechanismDefinition m = windows(2);
    const Motion motion = simulate(m, {.duration = 10.0, .instants = instants});
    for (const Instant& at : motion.instants) {
      for (const std::size_t level : {3u, 4u}) {
        EXPECT_LT((at.bodies[level].pose.R_WL - Matrix3d::Identity()).norm(),
                  1e-10);
      }
    }
    ASSERT_EQ(motion.change_points.size(), 10u);
    for (int i = 0; i < 10; ++i) {
      const ChangePoint& point =
          motion.change_points[static_cast<std::size_t>(i)];
      EXPECT_NEAR(point.t, 0.5 + i, 2e-5);
      // where the corner of the first upright lies on the next one's foot,
      // the second upright falls freely
      EXPECT_EQ(point.at.has_value(), i % 2 == 0);
    }
  }
}

// The same parallelogram in space has three redundant constraints: J is not
// square.
TEST(ChangePoint, IsLocatedAmongRedundantConstraints) {
  MechanismDefinition m = windows(1);
  m.dimension = SpaceDimension::kSpatial;
  m.drives[0].to = 2.2 * std::numbers::pi;
  const Motion motion = simulate(m, {.duration = 10.0, .instants = 57});
  ASSERT_EQ(motion.change_points.size(), 2u);
  // at pi and at 2 pi of 0.5 pi + 0.17 pi t
  EXPECT_NEAR(motion.change_points[0].t, 0.5 / 0.17, 1e-4);
  EXPECT_NEAR(motion.change_points[1].t, 1.5 / 0.17, 1e-4);
}

// Links 0.1 % off a parallelogram's: close to a change point, but none.
TEST(ChangePoint, CloseIsNotThere) {
  const FourBar links{
      .ground = 1.001, .crank = 1.0, .coupler = 1.001, .rocker = 1.001};
  const Motion motion =
      simulate(four_bar(links, 0.5), {.duration = 1.0, .instants = 57});
  EXPECT_TRUE(motion.change_points.empty());
}

TEST(ChangePoint, StopRefusesTheFirst) {
  try {
    simulate(landing_gear(0.190),
             {.duration = 2.0, .at_singularity = AtSingularity::kStop});
    FAIL() << "passed";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "K005");
    EXPECT_NE(error.problem().find("cylinder at 163.068 mm"), std::string::npos)
        << error.problem();
  }
}

}  // namespace
}  // namespace clevis::mechanism
