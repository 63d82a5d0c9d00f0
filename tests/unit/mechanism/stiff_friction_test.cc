// Friction laws that are stiff by their own small speeds: few evaluations, and
// rest where the closed forms say.
#include <cmath>

#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "mechanism/force_elements/contact.h"
#include "mechanism/force_laws/friction_law.h"
#include "mechanism/simulate.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

using Eigen::Vector3d;
using testing::on_joint;
using testing::sliders;

SimulationSettings settings(double duration, int instants) {
  SimulationSettings s;
  s.duration = duration;
  s.instants = instants;
  s.tolerance = 1e-8;
  return s;
}

TEST(StiffFriction, TanhOfTinySpeedHoldsByCreeping) {
  for (const double speed : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const FrictionLaw law{.model = FrictionModel::kRegularized,
                          .breakaway = 2.0,
                          .kinetic = 2.0,
                          .regularizing_speed = speed};
    MechanismDefinition m = sliders({1.0});
    m.elements = {on_joint(0, TableLaw{.times = {0.0}, .efforts = {1.5}}),
                  on_joint(0, law)};
    const Motion motion = simulate(m, settings(25.0, 11));
    const Instant& end = motion.instants.back();
    EXPECT_NEAR(end.elements[1].effort, -1.5, 1e-3) << speed;
    EXPECT_NEAR(end.bodies[0].pose.p_WL.x(), 25.0 * speed * std::atanh(0.75),
                1e-6 * 25.0)
        << speed;
    EXPECT_LT(motion.integration->evaluations, 20000) << speed;
  }
}

TEST(StiffFriction, StiffBristlesComeToRest) {
  const FrictionLaw law{.model = FrictionModel::kLuGre,
                        .breakaway = 3.0,
                        .kinetic = 2.0,
                        .stribeck_speed = 1e-3,
                        .bristle_stiffness = 1e8,
                        .bristle_damping = 1e4};
  MechanismDefinition m = sliders({1.0});
  m.elements = {on_joint(0, TableLaw{.times = {0.0}, .efforts = {1.9}}),
                on_joint(0, law)};
  const Motion motion = simulate(m, settings(100.0, 11));
  EXPECT_NEAR(motion.instants.back().elements[1].effort, -1.9, 1e-6);
  EXPECT_NEAR(motion.instants.back().bodies[0].pose.p_WL.x(), 0.0, 1e-6);
  EXPECT_LT(motion.integration->evaluations, 100000);
}

// Thrown at 1 m/s the wheel slides at μ g until it rolls: with I = m r²/2 at
// 2/3 of the speed, after v/(3 μ g).
TEST(StiffFriction, WheelRollsWhenItHasSlid) {
  constexpr double mu = 0.3, g = 9.81, r = 0.1, k = 1e6;
  MechanismDefinition m;
  BodyDefinition wheel =
      testing::uniform_bar("wheel", Vector3d(0.0, r - g / k, 0.0), 0.0, 0.1);
  wheel.mass_properties.p_LCm.setZero();
  wheel.mass_properties.inertia_LCm = 0.5 * r * r * Eigen::Matrix3d::Identity();
  m.bodies = {wheel};
  m.joints = {{.name = "plane",
               .type = JointType::kPlanar,
               .body_a = kGround,
               .body_b = 0,
               .frame_a = {},
               .frame_b = {},
               .place = "joint"}};
  m.gravity_W = {0.0, -g, 0.0};
  ContactElement ground;
  ground.name = "ground";
  ground.center.body = 0;
  ground.radius = r;
  ground.law = {.stiffness = k, .damping = 1e3};
  ground.static_friction = ground.kinetic_friction = mu;
  ground.critical_speed = 1e-9;
  m.elements = {ground};
  m.initial_bodies = {{.body = 0,
                       .v_WLo = {1.0, 0.0, 0.0},
                       .w_WL = Vector3d::Zero(),
                       .place = "initial"}};
  const Motion motion = simulate(m, settings(1.0, 11));
  const Instant& end = motion.instants.back();
  EXPECT_NEAR(end.bodies[0].v_WLo.x(), 2.0 / 3.0, 1e-6);
  EXPECT_NEAR(end.bodies[0].w_WL.z(), -2.0 / 3.0 / r, 1e-5);
  const double t = 1.0 / (3.0 * mu * g);
  EXPECT_NEAR(end.bodies[0].pose.p_WL.x(),
              t - 0.5 * mu * g * t * t + 2.0 / 3.0 * (1.0 - t), 1e-5);
  EXPECT_LT(motion.integration->evaluations, 50000);
}

/// Position after a second of 1 kg on 100 N/m, let go at 0.3 m, that a contact
/// of 10 N rubs: Runge-Kutta of order 4, two thousand steps through the peak.
double rubbed_mass(const ContactElement& contact, double normal) {
  struct State {
    double x, v;
  };
  const auto slope = [&](const State& y) {
    const Vector3d sliding(y.v, 0.0, 0.0);
    const double rub = sliding_friction(contact, sliding).coefficient.x();
    return State{y.v, -100.0 * y.x - normal * rub};
  };
  const auto along = [](const State& y, const State& k, double h) {
    return State{y.x + h * k.x, y.v + h * k.v};
  };
  State y{0.3, 0.0};
  constexpr int kSteps = 2000000;
  constexpr double h = 1.0 / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    const State a = slope(y), b = slope(along(y, a, 0.5 * h)),
                c = slope(along(y, b, 0.5 * h)), d = slope(along(y, c, h));
    y.x += h / 6.0 * (a.x + 2.0 * b.x + 2.0 * c.x + d.x);
    y.v += h / 6.0 * (a.v + 2.0 * b.v + 2.0 * c.v + d.v);
  }
  return y.x;
}

// Between its samples nothing else tells of a peak that takes 0.4 ms.
TEST(ContactFriction, PeakWhereSlidingTurnsRoundIsSeen) {
  MechanismDefinition m = testing::sliders({1.0});
  ContactElement contact;
  contact.name = "sole";
  contact.center.body = 0;
  contact.radius = 0.02;
  contact.plane.p_L = {0.0, -0.019, 0.0};
  contact.law = {.stiffness = 1e4};
  contact.static_friction = 0.4;
  m.elements = {on_joint(0, SpringLaw{.stiffness = 100.0}), contact};
  m.initial_joints = {
      {.joint = 0, .position = 0.3, .rate = 0.0, .place = "initial"}};
  const double known = rubbed_mass(contact, 10.0);
  for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9}) {
    SimulationSettings given = settings(1.0, 2);
    given.tolerance = tolerance;
    EXPECT_NEAR(simulate(m, given).instants.back().bodies[0].pose.p_WL.x(),
                known, tolerance)
        << tolerance;
  }
}

// Nothing does work but round-off.
TEST(PowerBalance, OfASteadyTurnIsNotRoundOffOverItself) {
  MechanismDefinition m;
  m.bodies = {testing::uniform_bar("wheel", Vector3d::Zero(), 0.0, 0.1)};
  m.bodies[0].mass_properties.p_LCm.setZero();
  m.joints = {testing::pin("axle", kGround, 0, 0.0, 0.0)};
  DriveDefinition drive;
  drive.law = DriveLaw::kRamp;
  drive.to = 10.0;
  drive.duration = 1.0;
  m.drives = {drive};
  for (const double gravity : {0.0, 9.81}) {
    m.gravity_W = {0.0, -gravity, 0.0};
    for (const Instant& at : simulate(m, settings(1.0, 11)).instants) {
      EXPECT_LT(at.power_balance_error, 1e-8);
    }
  }
}

TEST(Refusal, BodyLighterThanDoublePrecisionBears) {
  for (const double mass : {1e-11, 1e-13}) {
    std::string code;
    try {
      MechanismDefinition m = sliders({1.0, mass});
      simulate(m, settings(1.0, 2));
    } catch (const Error& error) {
      code = error.code();
    }
    EXPECT_EQ(code, mass < 1e-12 ? "K006" : "");
  }
}

TEST(StiffFriction, SlopesAreThoseOfTheLaws) {
  FrictionLaw law{.breakaway = 3.0,
                  .kinetic = 2.0,
                  .viscous = 0.7,
                  .stribeck_speed = 0.02,
                  .regularizing_speed = 0.013,
                  .bristle_stiffness = 300.0,
                  .bristle_damping = 5.0};
  constexpr double h = 1e-7;
  for (const auto model : {FrictionModel::kCoulomb, FrictionModel::kRegularized,
                           FrictionModel::kLuGre}) {
    law.model = model;
    for (const double v : {0.005, 0.03}) {
      constexpr double z = 0.004;
      const FrictionEffort at = friction_effort(law, 1, v, z);
      const FrictionEffort faster = friction_effort(law, 1, v + h, z + h);
      const FrictionEffort slower = friction_effort(law, 1, v - h, z - h);
      const FrictionEffort along = friction_along_tangent(law, at, h, h);
      EXPECT_NEAR((faster.per_load - slower.per_load) / (2.0 * h),
                  (along.per_load - at.per_load) / h, 1e-4);
      EXPECT_NEAR((faster.own - slower.own) / (2.0 * h),
                  (along.own - at.own) / h, 1e-3);
      EXPECT_NEAR((faster.bristle_rate - slower.bristle_rate) / (2.0 * h),
                  (along.bristle_rate - at.bristle_rate) / h, 1e-5);
    }
  }
  ContactElement contact;
  contact.static_friction = 0.6;
  contact.kinetic_friction = 0.4;
  contact.critical_speed = 0.01;
  for (const double size : {0.0, 0.004, 0.017}) {
    const Vector3d v = size * Vector3d(0.6, 0.0, 0.8);
    const SlidingFriction at = sliding_friction(contact, v);
    for (int i = 0; i < 3; ++i) {
      const Vector3d step = h * Vector3d::Unit(i);
      const Vector3d slope = (sliding_friction(contact, v + step).coefficient -
                              sliding_friction(contact, v - step).coefficient) /
                             (2.0 * h);
      EXPECT_LT((slope - at.slope.col(i)).norm(), 1e-3);
    }
  }
}

}  // namespace
}  // namespace clevis::mechanism
