// Records of impacts against closed forms of one mass on a spring.
#include <cmath>

#include <gtest/gtest.h>

#include "mechanism/simulate.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

using Eigen::Vector3d;
using testing::on_joint;
using testing::sliders;

SimulationSettings settings(double duration) {
  return {.duration = duration, .instants = 11, .tolerance = 1e-10};
}

InitialJointState start(int joint, double position, double rate) {
  return {.joint = joint, .position = position, .rate = rate, .place = "start"};
}

/// Distance of slider 1 from slider 0 along x, stopped below.
LineElement between(double lower, double stiffness) {
  LineElement stop;
  stop.name = "buffer";
  stop.line.kind = ElementLine::Kind::kSlide;
  stop.line.a.body = 0;
  stop.line.b.body = 1;
  stop.law =
      StopLaw{.lower = lower, .upper = {}, .contact = {.stiffness = stiffness}};
  return stop;
}

// m y'' = F − k y from y(0) = 0, y'(0) = v: peak F + √(F² + k m v²), held for
// (2/ω)(π − atan(v √(k m)/F)), impulse 2 m v + F times that.
TEST(Impact, MassThatIsPushedOnAStop) {
  const double mass = 2.0, k = 1e5, force = 300.0, way = 0.01;
  MechanismDefinition m = sliders({mass});
  m.elements = {
      on_joint(0,
               StopLaw{.lower = {}, .upper = way, .contact = {.stiffness = k}}),
      on_joint(0, TableLaw{.times = {0.0}, .efforts = {force}})};
  m.initial_joints = {start(0, 0.0, 1.0)};
  const Motion motion = simulate(m, settings(0.05));
  ASSERT_EQ(motion.impacts.size(), 1u);
  const Impact& impact = motion.impacts[0];
  const double v = std::sqrt(1.0 + 2.0 * force / mass * way);
  const double w = std::sqrt(k / mass);
  const double duration =
      2.0 / w * (M_PI - std::atan(v * std::sqrt(k * mass) / force));
  EXPECT_EQ(impact.element, 0);
  EXPECT_EQ(impact.end, 1);
  EXPECT_NEAR(impact.approach_speed, v, 1e-9);
  EXPECT_NEAR(impact.force, force, 1e-8 * force);
  EXPECT_NEAR(impact.mass, mass, 1e-12);
  EXPECT_NEAR(impact.mass_b, mass, 1e-12);
  EXPECT_TRUE(std::isinf(impact.mass_a));
  ASSERT_TRUE(impact.duration);
  EXPECT_NEAR(*impact.duration, duration, 1e-8 * duration);
  const double peak = force + std::sqrt(force * force + k * mass * v * v);
  EXPECT_NEAR(impact.peak_force, peak, 1e-8 * peak);
  EXPECT_NEAR(impact.peak_at - impact.t, 0.5 * duration, 1e-4 * duration);
  const double impulse = 2.0 * mass * v + force * duration;
  EXPECT_NEAR(impact.impulse, impulse, 1e-7 * impulse);
  EXPECT_NEAR(impact.exit_speed, v, 1e-8);
}

// Two free masses: π √(m/k) with the reduced mass m; each is known apart.
TEST(Impact, TwoSliders) {
  const double a = 3.0, b = 0.5, k = 2e4;
  MechanismDefinition m = sliders({a, b});
  m.elements = {between(0.1, k)};
  m.initial_joints = {start(0, 0.0, 0.0), start(1, 0.2, -2.0)};
  const Motion motion = simulate(m, settings(0.2));
  ASSERT_EQ(motion.impacts.size(), 1u);
  const Impact& impact = motion.impacts[0];
  const double reduced = a * b / (a + b);
  EXPECT_NEAR(impact.t, 0.05, 1e-10);
  EXPECT_NEAR(impact.mass_a, a, 1e-12);
  EXPECT_NEAR(impact.mass_b, b, 1e-12);
  EXPECT_NEAR(impact.mass, reduced, 1e-12);
  EXPECT_NEAR(impact.force, 0.0, 1e-9);
  EXPECT_NEAR(*impact.duration, M_PI * std::sqrt(reduced / k), 1e-9);
  EXPECT_NEAR(impact.impulse, 2.0 * reduced * 2.0, 1e-8);
}

// A drive holds slider 0: it cannot give way.
TEST(Impact, DrivenBodyWeighsInfinitelyMuch) {
  MechanismDefinition m = sliders({3.0, 0.5});
  m.elements = {between(0.1, 2e4)};
  m.drives = {{.joint = 0, .law = DriveLaw::kConstant, .place = "drive"}};
  m.initial_joints = {start(1, 0.2, -2.0)};
  const Motion motion = simulate(m, settings(0.2));
  ASSERT_EQ(motion.impacts.size(), 1u);
  EXPECT_TRUE(std::isinf(motion.impacts[0].mass_a));
  EXPECT_NEAR(motion.impacts[0].mass, 0.5, 1e-12);
}

/// A lever of 0.02 kg m² about its end that falls on the ground 0.3 m out.
MechanismDefinition lever() {
  MechanismDefinition m;
  BodyDefinition body =
      testing::uniform_bar("lever", Vector3d::Zero(), 0.0, 0.4);
  body.mass_properties.mass = 0.5;
  body.mass_properties.p_LCm = Vector3d(0.1, 0.0, 0.0);
  const double about_center = 0.02 - 0.5 * 0.01;
  body.mass_properties.inertia_LCm =
      Vector3d(about_center, about_center, about_center).asDiagonal();
  m.bodies = {body};
  m.joints = {{.name = "C",
               .type = JointType::kRevolute,
               .body_a = kGround,
               .body_b = 0,
               .frame_a = {},
               .frame_b = {},
               .place = "joint"}};
  ContactElement contact;
  contact.name = "touch";
  contact.center = {.body = 0, .p_L = Vector3d(0.3, 0.0, 0.0)};
  contact.radius = 0.01;
  contact.plane.p_L = Vector3d(0.0, -0.01, 0.0);
  contact.law.stiffness = 1e6;
  m.elements = {contact};
  return m;
}

// Strikes lying flat: J/r² along the normal, r ω the speed; gravity's torque
// over r the force.
TEST(Impact, LeverWeighsItsInertiaOverTheArm) {
  for (const auto dimension :
       {SpaceDimension::kPlanar, SpaceDimension::kSpatial}) {
    MechanismDefinition m = lever();
    m.dimension = dimension;
    m.gravity_W = {0.0, -10.0, 0.0};
    m.initial_joints = {start(0, 0.2, -3.0)};
    const Motion motion = simulate(m, settings(0.1));
    ASSERT_GE(motion.impacts.size(), 1u);
    const Impact& impact = motion.impacts[0];
    EXPECT_NEAR(impact.mass, 0.02 / 0.09, 1e-9);
    const double rate =
        std::sqrt(9.0 + 2.0 * 0.5 * 10.0 * 0.1 * std::sin(0.2) / 0.02);
    EXPECT_NEAR(impact.approach_speed, 0.3 * rate, 1e-8);
    EXPECT_NEAR(impact.force, 0.5 * 10.0 * 0.1 / 0.3, 1e-7);
  }
}

// A damper holds the mass back without letting it pull: one impact although
// the force ends while the spring is still deep.
TEST(Impact, DampedContactIsOneImpact) {
  const double mass = 1.0, k = 1e5, b = 200.0;
  MechanismDefinition m = sliders({mass});
  m.elements = {
      on_joint(0, StopLaw{.lower = 0.0,
                          .upper = {},
                          .contact = {.stiffness = k, .damping = b}})};
  m.initial_joints = {start(0, 0.1, -1.0)};
  const Motion motion = simulate(m, settings(0.2));
  ASSERT_EQ(motion.impacts.size(), 1u);
  const Impact& impact = motion.impacts[0];
  const double z = b / (2.0 * std::sqrt(k * mass));
  const double ratio = std::exp(-2.0 * z / std::sqrt(1.0 - z * z) *
                                std::atan(std::sqrt(1.0 - z * z) / z));
  EXPECT_NEAR(impact.exit_speed, ratio, 1e-7);
  EXPECT_NEAR(impact.impulse, mass * (1.0 + ratio), 1e-6);
  EXPECT_NEAR(impact.force, 0.0, 1e-9);
}

TEST(Impact, RestingContactIsNone) {
  MechanismDefinition m = sliders({1.0});
  m.elements = {
      on_joint(
          0, StopLaw{.lower = 0.0, .upper = {}, .contact = {.stiffness = 1e4}}),
      on_joint(0, TableLaw{.times = {0.0}, .efforts = {-10.0}})};
  m.initial_joints = {start(0, -1e-3, 0.0)};
  EXPECT_TRUE(simulate(m, settings(0.2)).impacts.empty());
}

/// A mass of 1 kg at a stop's lower end within round-off.
MechanismDefinition at_the_stop(double position, double rate, double force) {
  MechanismDefinition m = sliders({1.0});
  m.elements = {
      on_joint(0, StopLaw{.lower = 0.16,
                          .upper = {},
                          .contact = {.stiffness = 1e6, .damping = 100.0}}),
      on_joint(0, TableLaw{.times = {0.0}, .efforts = {force}})};
  m.initial_joints = {start(0, position, rate)};
  return m;
}

const double kAtTheStop[] = {0.16, std::nextafter(0.16, 0.0),
                             std::nextafter(0.16, 1.0), 0.16 - 1e-14,
                             0.16 + 1e-14};

// The sign of a depth that is round-off decides nothing.
TEST(Impact, WhatRestsAtAStopAtFirstIsNone) {
  for (const double position : kAtTheStop) {
    for (const double force : {-10.0, 10.0}) {
      const Motion motion =
          simulate(at_the_stop(position, 0.0, force), settings(0.1));
      EXPECT_TRUE(motion.impacts.empty()) << position - 0.16 << " " << force;
      EXPECT_TRUE(motion.events.empty()) << position - 0.16 << " " << force;
    }
  }
}

TEST(Impact, OfTheFirstInstant) {
  for (const double position : kAtTheStop) {
    const Motion motion =
        simulate(at_the_stop(position, -1.0, 0.0), settings(0.1));
    ASSERT_EQ(motion.impacts.size(), 1u) << position - 0.16;
    EXPECT_NEAR(motion.impacts[0].t, 0.0, 1e-12);
    EXPECT_NEAR(motion.impacts[0].approach_speed, 1.0, 1e-12);
  }
}

// Sliding that turns round passes Stribeck's zone, another piece of the
// contact's law; nothing is struck.
TEST(Impact, SlidingThatTurnsRoundIsNone) {
  MechanismDefinition m = sliders({1.0});
  ContactElement sole;
  sole.name = "sole";
  sole.center.body = 0;
  sole.radius = 0.02;
  sole.plane.p_L = {0.0, -0.019, 0.0};
  sole.law = {.stiffness = 1e4};
  sole.static_friction = 0.4;
  sole.kinetic_friction = 0.1;
  sole.critical_speed = 0.01;
  m.elements = {on_joint(0, SpringLaw{.stiffness = 100.0}), sole};
  m.initial_joints = {start(0, 0.3, 0.0)};
  EXPECT_TRUE(simulate(m, settings(1.0)).impacts.empty());
}

// A magnet F0 (1 − s/l) moves a mass by s: ½ m v² = F0 s (1 − s/(2 l)); beyond
// its range it coasts. Behind the first point the force is F0.
TEST(PositionTable, MagnetPullsAMass) {
  const double force = 60.0, range = 0.01, mass = 0.3;
  MechanismDefinition m = sliders({mass});
  m.elements = {on_joint(
      0, TableLaw{
             .times = {}, .efforts = {force, 0.0}, .positions = {0.0, range}})};
  m.initial_joints = {start(0, -0.005, 0.0)};
  const Motion motion = simulate(m, settings(0.05));
  for (const Instant& i : motion.instants) {
    const double x = i.bodies[0].pose.p_WL.x();
    const double s = std::clamp(x, 0.0, range);
    const double work = force * (std::min(x, 0.0) + 0.005) +
                        force * s * (1.0 - 0.5 * s / range);
    EXPECT_NEAR(0.5 * mass * std::pow(i.bodies[0].v_WLo.x(), 2), work, 1e-9);
  }
  EXPECT_GT(motion.instants.back().bodies[0].pose.p_WL.x(), range);
}

// A well of three points: the mass swings through its kinks with the energy
// that it has.
TEST(PositionTable, KeepsTheEnergyThroughItsKinks) {
  MechanismDefinition m = sliders({1.0});
  m.elements = {on_joint(0, TableLaw{.times = {},
                                     .efforts = {5.0, 0.0, -20.0},
                                     .positions = {-0.1, 0.0, 0.05}})};
  m.initial_joints = {start(0, 0.2, 0.0)};
  const Motion motion = simulate(m, settings(5.0));
  EXPECT_LT(motion.integration->relative_energy_error, 1e-8);
  EXPECT_TRUE(motion.events.empty());
  const auto energy = [](double x) {  // ∫ of the force back to 0
    if (x > 0.05) return 20.0 * (x - 0.05) + 0.5;
    if (x > 0.0) return 200.0 * x * x;
    if (x > -0.1) return 25.0 * x * x;
    return 0.25 + 5.0 * (-x - 0.1);
  };
  for (const Instant& i : motion.instants) {
    const double v = i.bodies[0].v_WLo.x();
    EXPECT_NEAR(0.5 * v * v + energy(i.bodies[0].pose.p_WL.x()), energy(0.2),
                1e-8);
  }
}

}  // namespace
}  // namespace clevis::mechanism
