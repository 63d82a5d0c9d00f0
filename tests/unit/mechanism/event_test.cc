// Modes that end for less than a sample of a step: events against closed forms.
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "mechanism/simulate.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

using Eigen::Vector3d;
using testing::on_joint;
using testing::sliders;

constexpr double kTolerances[] = {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8};
constexpr numerics::IntegratorChoice kChoices[] = {
    numerics::IntegratorChoice::kExplicit,
    numerics::IntegratorChoice::kImplicit};

SimulationSettings settings(double duration, double tolerance,
                            numerics::IntegratorChoice choice) {
  return {.duration = duration,
          .instants = 11,
          .tolerance = tolerance,
          .integrator = choice};
}

InitialJointState start(double position, double rate) {
  return {.joint = 0, .position = position, .rate = rate, .place = "start"};
}

StopLaw stop_above(double upper) {
  return {.lower = {}, .upper = upper, .contact = {.stiffness = 1e8}};
}

LineElement constant_force(double force) {
  return on_joint(0, TableLaw{.times = {0.0}, .efforts = {force}});
}

std::string label(double tolerance, numerics::IntegratorChoice choice) {
  return (choice == numerics::IntegratorChoice::kExplicit ? "explicit "
                                                          : "implicit ") +
         std::to_string(tolerance);
}

/// How much what the tolerance allows may move an event that a function passes
/// at this rate.
double allowed(double tolerance, double size, double rate) {
  return tolerance * size / rate;
}

// x = v t − g t²/2 meets a ceiling at a part of its apex.
TEST(Events, StopJustBelowAnApex) {
  const double v = 10.0, g = 9.81, apex = v * v / (2.0 * g);
  for (const double part : {0.9, 0.99, 0.998, 0.999, 0.9999}) {
    for (const double tolerance : kTolerances) {
      for (const numerics::IntegratorChoice choice : kChoices) {
        MechanismDefinition m = sliders({1.0});
        m.elements = {on_joint(0, stop_above(part * apex)), constant_force(-g)};
        m.initial_joints = {start(0.0, v)};
        const Motion motion =
            simulate(m, settings(1.9 * v / g, tolerance, choice));
        ASSERT_GE(motion.events.size(), 1u)
            << part << ' ' << label(tolerance, choice);
        const double left = std::sqrt(1.0 - part);
        EXPECT_NEAR(motion.events[0].t, v / g * (1.0 - left),
                    allowed(tolerance, apex, v * left))
            << part << ' ' << label(tolerance, choice);
      }
    }
  }
}

// A cos ω t from a phase, against a stop that it passes by a part of A, and one
// that it does not reach by as much.
TEST(Events, StopBesideAnAmplitude) {
  const double w = 100.0, amplitude = 0.05;
  for (const double part : {1e-2, 1e-3, 1e-4}) {
    for (int k = 0; k < 5; ++k) {
      const double phase = -M_PI + 0.3 * k + 0.01;
      for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
        for (const numerics::IntegratorChoice choice : kChoices) {
          MechanismDefinition m = sliders({1.0});
          m.initial_joints = {start(amplitude * std::cos(phase),
                                    -w * amplitude * std::sin(phase))};
          const LineElement spring = on_joint(0, SpringLaw{.stiffness = w * w});
          const auto events_with = [&](double stop) {
            m.elements = {spring, on_joint(0, stop_above(stop))};
            return simulate(m, settings((0.3 - phase) / w, tolerance, choice))
                .events;
          };
          const auto hit = events_with((1.0 - part) * amplitude);
          ASSERT_GE(hit.size(), 1u)
              << part << ' ' << phase << ' ' << label(tolerance, choice);
          const double angle = std::acos(1.0 - part);
          EXPECT_NEAR(
              hit[0].t, (-phase - angle) / w,
              allowed(tolerance, amplitude, w * amplitude * std::sin(angle)));
          if (tolerance < part) {
            EXPECT_TRUE(events_with((1.0 + part) * amplitude).empty());
          }
        }
      }
    }
  }
}

// At rest, a servo pulls with F sin ω t; breakaway is F / 1.02.
TEST(Events, RestThatOnlyTimeEnds) {
  for (const double frequency : {1.0, 10.0, 78.0}) {
    for (const double tolerance : kTolerances) {
      ServoLaw servo{.stiffness = 1000.0};
      servo.reference = {
          .law = DriveLaw::kSine, .amplitude = 0.0102, .frequency = frequency};
      MechanismDefinition m = sliders({1.0});
      m.elements = {
          on_joint(0, servo),
          on_joint(0, FrictionLaw{.breakaway = 10.0, .kinetic = 8.0})};
      SimulationSettings s = settings(10.0 / frequency, tolerance,
                                      numerics::IntegratorChoice::kAuto);
      const Motion motion = simulate(m, s);
      ASSERT_GE(motion.events.size(), 1u) << frequency << ' ' << tolerance;
      EXPECT_EQ(motion.events[0].what, "slip");
      const double t = std::asin(1.0 / 1.02) / (2.0 * M_PI * frequency);
      EXPECT_NEAR(motion.events[0].t, t, 1e-12 / frequency);
    }
  }
  // breakaway above the peak holds for a hundred periods
  ServoLaw servo{.stiffness = 1000.0};
  servo.reference = {
      .law = DriveLaw::kSine, .amplitude = 0.0099999, .frequency = 10.0};
  MechanismDefinition m = sliders({1.0});
  m.elements = {on_joint(0, servo),
                on_joint(0, FrictionLaw{.breakaway = 10.0, .kinetic = 8.0})};
  EXPECT_TRUE(
      simulate(m, settings(10.0, 1e-8, numerics::IntegratorChoice::kAuto))
          .events.empty());
}

// The speed would come to −dip once a period, without regard to friction's
// sense; friction that holds more than all loads must keep the slide at rest.
TEST(Events, SlideThatDipsBelowRest) {
  const double kinetic = 8.0;
  for (const double dip : {1e-2, 1e-3, 1e-4}) {
    for (const double tolerance : kTolerances) {
      if (dip < 10.0 * tolerance) continue;
      for (const numerics::IntegratorChoice choice : kChoices) {
        // x'' = −k (x − r), slow against the spring's period: v = v₀ cos ω t
        // + c, c below v₀ by the dip, so that v is least at half a period
        const double w = 20.0, v0 = 1.0, c = v0 - dip;
        MechanismDefinition m = sliders({1.0});
        m.elements = {
            on_joint(0, ServoLaw{.reference = {.law = DriveLaw::kRamp,
                                               .to = 10.0 * c,
                                               .duration = 10.0},
                                 .stiffness = w * w}),
            constant_force(kinetic),
            on_joint(0, FrictionLaw{.breakaway = 1e3, .kinetic = kinetic})};
        m.initial_joints = {start(0.0, v0 + c)};
        const Motion motion = simulate(m, settings(0.25, tolerance, choice));
        ASSERT_GE(motion.events.size(), 1u)
            << dip << ' ' << label(tolerance, choice);
        EXPECT_EQ(motion.events[0].what, "stick");
        const double angle = std::acos(-c / v0);
        EXPECT_NEAR(motion.events[0].t, angle / w,
                    allowed(tolerance, v0, v0 * w * std::sin(angle)));
      }
    }
  }
}

// A ball under gravity dips into a plane for less than a sample of its step.
TEST(Events, ContactGrazed) {
  const double v = 30.0, g = 9.81, apex = v * v / (2.0 * g);
  for (const double part : {0.99, 0.998, 0.9999}) {
    for (const double tolerance : kTolerances) {
      MechanismDefinition m;
      BodyDefinition ball =
          testing::uniform_bar("ball", Vector3d::Zero(), 0.0, 1.0);
      ball.mass_properties.p_LCm.setZero();
      m.bodies = {ball};
      m.gravity_W = Vector3d(0.0, -g, 0.0);
      ContactElement ceiling;
      ceiling.name = "ceiling";
      ceiling.center.body = 0;
      ceiling.plane.p_L = Vector3d(0.0, part * apex, 0.0);
      ceiling.normal_L = -Vector3d::UnitY();
      ceiling.law.stiffness = 1e8;
      m.elements = {ceiling};
      InitialBodyState initial;
      initial.body = 0;
      initial.v_WLo = Vector3d(0.0, v, 0.0);
      m.initial_bodies = {initial};
      const Motion motion = simulate(
          m,
          settings(1.9 * v / g, tolerance, numerics::IntegratorChoice::kAuto));
      ASSERT_GE(motion.events.size(), 1u) << part << ' ' << tolerance;
      const double left = std::sqrt(1.0 - part);
      EXPECT_NEAR(motion.events[0].t, v / g * (1.0 - left),
                  allowed(tolerance, apex, v * left));
    }
  }
}

}  // namespace
}  // namespace clevis::mechanism
