#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "mechanism/simulate.h"
#include "support/free_linkages.h"

namespace clevis::mechanism {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

SimulationSettings settings(double duration, int instants, double tolerance) {
  SimulationSettings s;
  s.duration = duration;
  s.instants = instants;
  s.tolerance = tolerance;
  return s;
}

Vector2d tip(const Instant& instant, std::size_t body) {
  const Pose& pose = instant.bodies[body].pose;
  return (pose.p_WL + pose.R_WL.col(0)).head<2>();
}

Vector2d tip_velocity(const Instant& instant, std::size_t body) {
  const BodyState& state = instant.bodies[body];
  return (state.v_WLo + state.w_WL.cross(state.pose.R_WL.col(0))).head<2>();
}

constexpr double kTolerances[] = {1e-3, 1e-4, 1e-5, 1e-6,
                                  1e-7, 1e-8, 1e-9, 1e-10};

/// Largest distance from the reference at 1 s, 5 s and 10 s.
double path_error(const Motion& motion, const Vector2d& at_1,
                  const Vector2d& at_5, const Vector2d& at_10) {
  return std::max({(tip(motion.instants[1], 0) - at_1).norm(),
                   (tip(motion.instants[5], 0) - at_5).norm(),
                   (tip(motion.instants[10], 0) - at_10).norm()});
}

/// The error is what was asked for, down to the round-off of the reference
/// and of 10 s of motion.
constexpr double kRoundOff = 2e-10;

// Reference: Jacobi's elliptic functions.
TEST(ForwardDynamics, SimplePendulumFollowsTheClosedForm) {
  for (const double lever : {0.5, 1.0}) {
    const auto pendulum = testing::simple_pendulum(lever);
    for (const double tolerance : kTolerances) {
      const Motion motion = simulate(pendulum, settings(10.0, 11, tolerance));
      EXPECT_LT(path_error(motion, {0.986291751131875, -0.165010853125541},
                           {-0.942305435043757, -0.334754338414001},
                           {-0.275087462576117, -0.961419205099125}),
                tolerance + kRoundOff);
      if (lever != 1.0) continue;
      for (const Instant& instant : motion.instants) {
        // weight's part along the rod, and centripetal force
        EXPECT_NEAR(instant.joints[0].f_W.norm(),
                    3.0 * 9.81 * std::abs(tip(instant, 0).y()),
                    30.0 * (tolerance + kRoundOff));
      }
    }
  }
}

// Reference: converged to the digits shown.
//
// Late by δt, the tip is |v| δt off its place and |a| δt off its velocity: at
// 10 s |a| / |v| is 2.9 1/s by 3/2 w² + 7/2 g sin = const.
TEST(ForwardDynamics, TwoWindowFourBarKeepsItsBranchAtChangePoints) {
  constexpr double kAccelerationOverSpeed = 2.95;
  const auto bars = testing::two_window_four_bar();
  for (const double tolerance : kTolerances) {
    const Motion motion = simulate(bars, settings(10.0, 11, tolerance));
    EXPECT_LT(path_error(motion, {-0.195020301949, -0.980799205662},
                         {-0.811310461004, -0.584615545351},
                         {0.328458111539, 0.944518538179}),
              2.0 * tolerance + 10.0 * kRoundOff)
        << tolerance;
    EXPECT_LT((tip_velocity(motion.instants[10], 0) -
               Vector2d(1.423051470203, -0.494868845483))
                  .norm(),
              kAccelerationOverSpeed * (2.0 * tolerance + 10.0 * kRoundOff))
        << tolerance;
    EXPECT_LT(motion.integration->energy_error,
              2.0 * tolerance + 50.0 * kRoundOff)
        << tolerance;
    for (const Instant& instant : motion.instants) {
      for (std::size_t k = 1; k < 3; ++k) {
        EXPECT_LT(
            (instant.bodies[k].pose.R_WL - instant.bodies[0].pose.R_WL).norm(),
            1e-8);
      }
    }
  }
}

// At the change point itself the joints leave a second freedom; the velocity
// given decides the branch.
TEST(ForwardDynamics, StartsAtTheChangePointAndBesideIt) {
  for (const double beside : {0.0, 1e-12}) {
    auto bars = testing::two_window_four_bar();
    for (std::size_t i = 0; i < 3; ++i) {
      bars.bodies[i].placement.R_WL = testing::turned(-beside);
    }
    for (std::size_t i = 3; i < 5; ++i) {
      bars.bodies[i].placement.p_WL =
          Vector3d(static_cast<double>(i) - 2.0, -beside, 0.0);
    }
    bars.initial_joints.clear();
    for (int i = 0; i < 3; ++i) {
      bars.initial_joints.push_back(
          {.joint = i, .position = {}, .rate = -4.0, .place = "initial"});
    }
    const Motion motion = simulate(bars, settings(5.0, 11, 1e-8));
    EXPECT_LT(motion.integration->relative_energy_error, 1e-6);
    for (const Instant& instant : motion.instants) {
      EXPECT_LT(
          (instant.bodies[2].pose.R_WL - instant.bodies[0].pose.R_WL).norm(),
          1e-8);
    }
  }
}

// A chain of a heavy and a light body; energy is the oracle.
TEST(ForwardDynamics, MassRatioOfAMillion) {
  for (const double light : {1e-6, 1e6}) {
    MechanismDefinition m;
    m.bodies = {testing::uniform_bar("first", Vector3d::Zero(), 0.0, 1.0),
                testing::uniform_bar("second", {1.0, 0.0, 0.0}, 0.5, 1.0)};
    m.bodies[1].mass_properties.mass *= light;
    m.bodies[1].mass_properties.inertia_LCm *= light;
    m.joints = {testing::pin("O", kGround, 0, 0.0, 0.0),
                testing::pin("E", 0, 1, 1.0, 0.0)};
    m.gravity_W = {0.0, -9.81, 0.0};
    const Motion motion = simulate(m, settings(5.0, 11, 1e-8));
    EXPECT_LT(motion.integration->relative_energy_error, 1e-7) << light;
    EXPECT_LT(motion.instants.back().closure_error, 1e-12);
  }
}

TEST(ForwardDynamics, LongRunDoesNotDrift) {
  const Motion motion =
      simulate(testing::simple_pendulum(0.5), settings(1000.0, 101, 1e-8));
  EXPECT_LT(motion.integration->relative_energy_error, 1e-6);
  for (const Instant& instant : motion.instants) {
    EXPECT_LT(instant.closure_error, 1e-12);
  }
}

// One drive and one free coordinate: a bar on a cart that accelerates.
TEST(ForwardDynamics, DriveAndFreedomTogether) {
  MechanismDefinition m;
  m.bodies = {testing::uniform_bar("crank", Vector3d::Zero(), 0.0, 1.0),
              testing::uniform_bar("flail", {1.0, 0.0, 0.0}, 0.0, 1.0)};
  m.joints = {testing::pin("O", kGround, 0, 0.0, 0.0),
              testing::pin("E", 0, 1, 1.0, 0.0)};
  DriveDefinition spin;
  spin.joint = 0;
  spin.law = DriveLaw::kRamp;
  spin.to = 20.0;
  spin.duration = 2.0;
  m.drives = {spin};
  m.initial_joints = {
      {.joint = 1, .position = {}, .rate = 1.0, .place = "initial"}};
  const Motion motion = simulate(m, settings(2.0, 21, 1e-9));
  // no gravity: φ'' = −ω² r/l_eff sin φ, l_eff = 2/3; energy integral of it
  const double w2 = 100.0 / (2.0 / 3.0);
  for (const Instant& instant : motion.instants) {
    const double rate = instant.bodies[1].w_WL.z() - instant.bodies[0].w_WL.z();
    const Vector3d u = instant.bodies[0].pose.R_WL.col(0);
    const Vector3d v = instant.bodies[1].pose.R_WL.col(0);
    EXPECT_NEAR(0.5 * rate * rate - w2 * u.dot(v), 0.5 - w2, 1e-6);
    EXPECT_NEAR(instant.bodies[0].w_WL.z(), 10.0, 1e-12);
    EXPECT_LT(instant.power_balance_error, 1e-12);
  }
  EXPECT_LT(motion.integration->relative_energy_error, 1e-7);
}

TEST(ForwardDynamics, ContradictoryRatesAreRefused) {
  auto bars = testing::two_window_four_bar();
  bars.initial_joints.push_back(
      {.joint = 1, .position = {}, .rate = 1.0, .place = "scene:1:1"});
  EXPECT_THROW(simulate(bars, settings(1.0, 3, 1e-8)), Error);
}

}  // namespace
}  // namespace clevis::mechanism
