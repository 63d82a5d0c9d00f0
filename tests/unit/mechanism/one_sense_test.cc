// Forces that act on one sense of motion, steps of force tables in integrated
// motions, and drives of constant rate.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "mechanism/drives/drive_law.h"
#include "mechanism/simulate.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

SimulationSettings free_for(double duration, int instants = 21) {
  SimulationSettings s;
  s.duration = duration;
  s.instants = instants;
  s.tolerance = 1e-10;
  s.motion = MotionKind::kDynamic;
  s.at_peaks = true;
  return s;
}

LineElement constant_effort(double effort, ActsOn sense) {
  LineElement element =
      testing::on_joint(0, TableLaw{.times = {0.0}, .efforts = {effort}});
  element.acts_on = sense;
  return element;
}

/// 1 kg on 100 N/m at x = 0 with 1 m/s.
MechanismDefinition swinging() {
  MechanismDefinition m = testing::sliders({1.0});
  m.elements.push_back(testing::on_joint(0, SpringLaw{.stiffness = 100.0}));
  m.initial_joints = {
      {.joint = 0, .position = 0.0, .rate = 1.0, .place = "initial"}};
  return m;
}

// Against F on the way up only: k A^2/2 + F A = v^2/2; back by the spring
// alone.
TEST(OneSense, SlowsTheWayUpAlone) {
  MechanismDefinition m = swinging();
  m.elements.push_back(constant_effort(-5.0, ActsOn::kIncreasing));
  const double top = (-5.0 + std::sqrt(25.0 + 100.0)) / 100.0;
  const Motion motion = simulate(m, free_for(0.5));
  double most = 0.0;
  int falling = 0;
  for (const Instant& i : motion.instants) {
    const double x = i.elements[0].position, v = i.elements[0].rate;
    most = std::max(most, x);
    const bool rises = i.elements[1].rate > 1e-6;
    const bool falls = i.elements[1].rate < -1e-6;
    if (rises) {
      EXPECT_EQ(i.elements[1].effort, -5.0) << i.t;
    }
    if (falls) {
      ++falling;
      EXPECT_EQ(i.elements[1].effort, 0.0) << i.t;
      EXPECT_NEAR(v * v + 100.0 * x * x, 100.0 * top * top, 1e-7) << i.t;
    }
  }
  EXPECT_GT(falling, 5);
  EXPECT_NEAR(most, top, 1e-6);
  ASSERT_FALSE(motion.events.empty());
  EXPECT_EQ(motion.events[0].what, "rest");
  // x = -0.05 + sqrt(0.05^2 + 0.1^2) sin(10 t + atan 0.5) is highest there
  EXPECT_NEAR(motion.events[0].t, (M_PI_2 - std::atan(0.5)) / 10.0, 1e-8);
}

TEST(OneSense, TheOtherWayIsItsMirrorImage) {
  MechanismDefinition m = swinging();
  m.initial_joints[0].rate = -1.0;
  m.elements.push_back(constant_effort(5.0, ActsOn::kDecreasing));
  const Motion motion = simulate(m, free_for(0.5));
  double least = 0.0;
  for (const Instant& i : motion.instants) {
    least = std::min(least, i.elements[0].position);
  }
  EXPECT_NEAR(least, -(-5.0 + std::sqrt(125.0)) / 100.0, 1e-6);
}

// A damper in rebound only: that way the swing decays as the damped one does.
TEST(OneSense, DamperInRebound) {
  MechanismDefinition m = swinging();
  LineElement damper = testing::on_joint(0, SpringLaw{.damping = 4.0});
  damper.acts_on = ActsOn::kIncreasing;
  m.elements.push_back(damper);
  const double damped = std::sqrt(100.0 - 4.0);
  const double at = std::atan2(damped, 2.0) / damped;
  const double top = std::exp(-2.0 * at) * std::sin(damped * at) / damped;
  const Motion motion = simulate(m, free_for(0.6));
  double most = 0.0, least = 0.0;
  for (const Instant& i : motion.instants) {
    most = std::max(most, i.elements[0].position);
    least = std::min(least, i.elements[0].position);
  }
  EXPECT_NEAR(most, top, 1e-5);
  EXPECT_NEAR(least, -top, 1e-3);  // back without damping
}

// What stops its own motion and is pushed on again has no end, unless the force
// grows over a speed: then it creeps where it holds 3 N of 8 N.
TEST(OneSense, WhatStopsItsOwnMotionWantsAFullSpeed) {
  MechanismDefinition m = testing::sliders({1.0});
  m.elements = {
      testing::on_joint(0, TableLaw{.times = {0.0}, .efforts = {3.0}}),
      constant_effort(-8.0, ActsOn::kIncreasing)};
  EXPECT_THROW(simulate(m, free_for(1.0)), Error);
  std::get<LineElement>(m.elements[1]).full_speed = 0.01;
  const Motion motion = simulate(m, free_for(1.0));
  // 8 s^2 (3 - 2 s) = 3
  double s = 0.4;
  for (int i = 0; i < 50; ++i) {
    s -= (s * s * (3.0 - 2.0 * s) - 0.375) / (6.0 * s * (1.0 - s));
  }
  EXPECT_NEAR(motion.instants.back().elements[1].rate, 0.01 * s, 1e-9);
}

TEST(OneSense, OfADrivenMotion) {
  MechanismDefinition m = testing::sliders({1.0});
  m.drives = {{.joint = 0,
               .law = DriveLaw::kSine,
               .amplitude = 0.1,
               .frequency = 1.0,
               .place = "drive"}};
  m.elements = {constant_effort(-50.0, ActsOn::kIncreasing)};
  SimulationSettings s;
  s.duration = 1.0;
  s.instants = 4;
  s.at_peaks = true;
  const Motion motion = simulate(m, s);
  double most = 0.0;
  for (const Instant& i : motion.instants) {
    most = std::max(most, i.drives[0].effort);
  }
  // just behind the lower turn, at 0.75 s
  EXPECT_NEAR(most, 50.0 + 0.4 * M_PI * M_PI, 1e-5);
  ASSERT_EQ(motion.events.size(), 2u);
  EXPECT_EQ(motion.events[0].what, "rest");
  EXPECT_NEAR(motion.events[0].t, 0.25, 1e-8);
  EXPECT_EQ(motion.events[1].what, "act");
}

// 10 N from 0.3 s to 0.7 s, at once: 4 m/s and 2 m more than at rest.
TEST(TableSteps, AreIntegratedExactly) {
  MechanismDefinition m = testing::sliders({1.0});
  m.elements = {testing::on_joint(
      0, TableLaw{.times = {0.3, 0.3, 0.7, 0.7}, .efforts = {0, 10, 10, 0}})};
  const Motion motion = simulate(m, free_for(1.0, 2));
  EXPECT_NEAR(motion.instants.back().elements[0].rate, 4.0, 1e-11);
  EXPECT_NEAR(motion.instants.back().elements[0].position, 0.8 + 1.2, 1e-11);
  EXPECT_LT(motion.integration->steps, 100);
  EXPECT_LT(motion.integration->rejected, 20);
  const auto sides = [&](double t) {
    const auto next =
        std::ranges::find_if(motion.instants, [&](const Instant& i) {
          return i.t > t;
        });
    return std::pair{(next - 1)->elements[0].effort, next->elements[0].effort};
  };
  EXPECT_EQ(sides(0.3), (std::pair{0.0, 10.0}));
  EXPECT_EQ(sides(0.7), (std::pair{10.0, 0.0}));
}

TEST(SpeedLaw, RunsFromItsStartOn) {
  DriveDefinition drive;
  drive.law = DriveLaw::kSpeed;
  drive.from = 0.2;
  drive.speed = -3.0;
  drive.start = 0.5;
  EXPECT_EQ(drive_target(drive, 0.4).position, 0.2);
  EXPECT_EQ(drive_target(drive, 0.4).rate, 0.0);
  EXPECT_NEAR(drive_target(drive, 1.5).position, -2.8, 1e-15);
  EXPECT_EQ(drive_target(drive, 1.5).rate, -3.0);
  EXPECT_EQ(drive_target(drive, 1.5).acceleration, 0.0);
}

// It jumps where it starts, but not from the beginning of the motion.
TEST(SpeedLaw, JumpsAtALaterStart) {
  MechanismDefinition m = testing::sliders({1.0});
  m.drives = {{.joint = 0, .law = DriveLaw::kSpeed, .place = "drive"}};
  m.drives[0].speed = 2.0;
  EXPECT_TRUE(drive_jumps(m.drives, 1.0).empty());
  m.drives[0].start = 0.25;
  const auto jumps = drive_jumps(m.drives, 1.0);
  ASSERT_EQ(jumps.size(), 1u);
  EXPECT_EQ(jumps[0].t, 0.25);
  EXPECT_EQ(jumps[0].before, 0.0);
  EXPECT_EQ(jumps[0].behind, 2.0);
}

}  // namespace
}  // namespace clevis::mechanism
