#include "mechanism/line_elements/motor.h"

#include <array>
#include <cmath>
#include <complex>

#include <gtest/gtest.h>

#include "mechanism/simulate.h"
#include "support/four_bar.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

using Eigen::Vector3d;

/// The motor of the braiding device [Perechesova2014], with numbers of its
/// size.
MotorLaw published(DirectAxis d_axis) {
  MotorLaw law;
  law.ratio = 87.121;
  law.pole_pairs = 4;
  law.resistance = 1.0;
  law.inductance = 1e-3;
  law.flux = 0.02;
  law.rotor_inertia = 2.6e-4;
  law.times = {0.0};
  law.volts = {12.57};
  law.d_axis = d_axis;
  return law;
}

constexpr double kTotalInertia = 2.64e-4;  // at the rotor [kg m²]

/// A disc on the joint that makes up for the rest of the inertia.
MechanismDefinition disc(const MotorLaw& law) {
  MechanismDefinition m;
  BodyDefinition body =
      testing::uniform_bar("disc", Vector3d::Zero(), 0.0, 0.1);
  body.mass_properties.p_LCm.setZero();
  const double inertia =
      (kTotalInertia - law.rotor_inertia) * law.ratio * law.ratio;
  body.mass_properties.inertia_LCm = inertia * Eigen::Matrix3d::Identity();
  m.bodies = {body};
  m.joints = {testing::pin("shaft", kGround, 0, 0.0, 0.0)};
  m.elements = {testing::on_joint(0, law)};
  return m;
}

SimulationSettings settings(double duration, int instants,
                            double tolerance = 1e-10) {
  SimulationSettings s;
  s.duration = duration;
  s.instants = instants;
  s.tolerance = tolerance;
  return s;
}

const MotorState& motor_at(const Instant& instant, std::size_t element = 0) {
  return *instant.elements[element].motor;
}

struct Course {
  double i_d{}, i_q{}, w{};
};

/// The motor alone by Runge-Kutta's classical steps.
Course runge_kutta(const MotorLaw& m, double until, int steps) {
  using State = std::array<double, 3>;
  const auto rates = [&m](const State& y) {
    const double e = m.pole_pairs * y[2];
    const double v_d =
        m.d_axis == DirectAxis::kDecoupled ? -e * m.inductance * y[1] : 0.0;
    return State{
        (v_d - m.resistance * y[0]) / m.inductance + e * y[1],
        (m.volts[0] - m.resistance * y[1] - e * m.flux) / m.inductance -
            e * y[0],
        1.5 * m.pole_pairs * m.flux * y[1] / kTotalInertia};
  };
  State y{};
  const double h = until / steps;
  const auto ahead = [&y](const State& k, double step) {
    return State{y[0] + step * k[0], y[1] + step * k[1], y[2] + step * k[2]};
  };
  for (int i = 0; i < steps; ++i) {
    const State k1 = rates(y), k2 = rates(ahead(k1, h / 2)),
                k3 = rates(ahead(k2, h / 2)), k4 = rates(ahead(k3, h));
    for (std::size_t j = 0; j < 3; ++j) {
      y[j] += h / 6 * (k1[j] + 2 * k2[j] + 2 * k3[j] + k4[j]);
    }
  }
  return {y[0], y[1], y[2]};
}

// Decoupled it is a direct-current motor: two eigenvalues.
TEST(Motor, DecoupledRunsUpAsItsClosedFormSays) {
  const MotorLaw law = published(DirectAxis::kDecoupled);
  const Motion motion = simulate(disc(law), settings(0.15, 31));
  const double p = law.pole_pairs, top = 12.57 / (p * law.flux);
  // w'' + (R/L) w' + (3/2) p² ψ²/(L J) (w − top) = 0
  const double b = law.resistance / law.inductance;
  const double c =
      1.5 * p * p * law.flux * law.flux / (law.inductance * kTotalInertia);
  const std::complex<double> root = std::sqrt(std::complex(b * b / 4 - c));
  const std::complex<double> s1 = -b / 2 + root, s2 = -b / 2 - root;
  for (const Instant& instant : motion.instants) {
    const double t = instant.t;
    const auto w =
        top *
        (1.0 + (s2 * std::exp(s1 * t) - s1 * std::exp(s2 * t)) / (s1 - s2));
    EXPECT_NEAR(motor_at(instant).speed, w.real(), 1e-8 * top) << t;
    EXPECT_NEAR(motor_at(instant).current_d, 0.0, 1e-12);
  }
}

// Source S11: within 2 % for good at 0.1046 s and 0.1324 s.
TEST(Motor, SettlesWhenTheSourceSays) {
  for (const auto& [d_axis, known] : {std::pair{DirectAxis::kDecoupled, 0.1046},
                                      std::pair{DirectAxis::kZero, 0.1324}}) {
    const MotorLaw law = published(d_axis);
    const Motion motion = simulate(disc(law), settings(0.3, 30001));
    const double top = 12.57 / (law.pole_pairs * law.flux);
    double settled = 0.0;
    for (const Instant& instant : motion.instants) {
      if (std::abs(motor_at(instant).speed / top - 1.0) > 0.02) {
        settled = instant.t;
      }
    }
    EXPECT_NEAR(settled, known, 5e-5);
    const double rate = motion.instants.back().elements[0].rate;
    EXPECT_NEAR(rate, 1.803, 1e-3);
  }
}

TEST(Motor, WithoutVoltageOnTheDirectAxisRunsAsByRungeKutta) {
  const MotorLaw law = published(DirectAxis::kZero);
  for (const double t : {0.01, 0.05, 0.1}) {
    const Instant last = simulate(disc(law), settings(t, 2)).instants.back();
    const Course known = runge_kutta(law, t, 20000);
    EXPECT_NEAR(motor_at(last).speed, known.w, 1e-7 * known.w) << t;
    EXPECT_NEAR(motor_at(last).current_d, known.i_d, 1e-7);
    EXPECT_NEAR(motor_at(last).current_q, known.i_q, 1e-7);
    EXPECT_GT(std::abs(known.i_d), 0.1);
  }
}

TEST(Motor, EnergySuppliedIsLostStoredAndGiven) {
  for (const DirectAxis d_axis : {DirectAxis::kDecoupled, DirectAxis::kZero}) {
    MotorLaw law = published(d_axis);
    law.times = {0.0, 0.03, 0.06};
    law.volts = {0.0, 12.57, -5.0};
    const Motion motion = simulate(disc(law), settings(0.1, 11));
    for (const Instant& instant : motion.instants) {
      const MotorState& m = motor_at(instant);
      EXPECT_NEAR(m.supplied, m.lost + m.stored + m.given, 1e-9);
      EXPECT_NEAR(m.given, 0.5 * kTotalInertia * m.speed * m.speed, 1e-9);
    }
    EXPECT_GT(motor_at(motion.instants.back()).lost, 1.0);
    EXPECT_LT(motion.integration->relative_energy_error, 1e-8);
  }
}

// Turned by a drive, its windings shorted: the brake of the characteristic
// currents.
TEST(Motor, ShortedWindingsBrakeAsTheirClosedFormSays) {
  MotorLaw law = published(DirectAxis::kZero);
  law.volts = {0.0};
  MechanismDefinition m = disc(law);
  DriveDefinition turn;
  turn.joint = 0;
  turn.law = DriveLaw::kRamp;
  turn.to = 2.0;
  turn.duration = 1.0;
  m.drives = {turn};
  const Instant last = simulate(m, settings(0.2, 2)).instants.back();
  const double e = law.pole_pairs * law.ratio * 2.0;
  const double reactance = e * law.inductance;
  const double both = 1.0 + reactance * reactance;  // R = 1
  EXPECT_NEAR(motor_at(last).current_q, -e * law.flux / both, 1e-9);
  EXPECT_NEAR(motor_at(last).current_d, -reactance * e * law.flux / both, 1e-9);
  const double brake = 1.5 * 4 * 0.02 * e * law.flux / both;
  EXPECT_NEAR(last.elements[0].effort, -law.ratio * brake, 1e-7);
  EXPECT_NEAR(last.drives[0].effort, law.ratio * brake, 1e-7);
  EXPECT_NEAR(motor_at(last).power, 0.0, 1e-12);
}

/// Accelerated by a drive, without flux to speak of: the drive turns the rotor.
TEST(Motor, DriveFeelsTheRotorBehindTheGear) {
  for (const SpaceDimension space :
       {SpaceDimension::kPlanar, SpaceDimension::kSpatial}) {
    MotorLaw law = published(DirectAxis::kZero);
    law.volts = {0.0};
    law.flux = 1e-9;
    law.ratio = -20.0;
    MechanismDefinition m = disc(law);
    m.dimension = space;
    DriveDefinition turn;
    turn.joint = 0;
    turn.law = DriveLaw::kQuintic;
    turn.to = 2.0;
    turn.duration = 1.0;
    m.drives = {turn};
    const Motion motion = simulate(m, settings(1.0, 11));
    for (const Instant& instant : motion.instants) {
      const double needed =
          kTotalInertia * 400.0 * instant.drives[0].acceleration;
      EXPECT_NEAR(instant.drives[0].effort, needed, 1e-9);
      EXPECT_LT(instant.power_balance_error, 1e-9);
    }
    EXPECT_LT(motion.integration->relative_energy_error, 1e-8);
  }
}

/// Crank-rocker on the motor, or the same with the rotor as a body of its own
/// that a gear ties to the crank.
MechanismDefinition crank_rocker(bool own_rotor) {
  const testing::FourBar lengths{
      .ground = 0.045, .crank = 0.010, .coupler = 0.040, .rocker = 0.025};
  MechanismDefinition m = testing::four_bar(lengths, 0.3);
  m.drives.clear();
  MotorLaw law = published(DirectAxis::kZero);
  if (!own_rotor) {
    m.elements = {testing::on_joint(0, law)};
    return m;
  }
  BodyDefinition rotor =
      testing::uniform_bar("rotor", Vector3d::Zero(), 0.0, 0.1);
  rotor.mass_properties.p_LCm.setZero();
  rotor.mass_properties.inertia_LCm =
      law.rotor_inertia * Eigen::Matrix3d::Identity();
  const int body = static_cast<int>(m.bodies.size());
  const int joint = static_cast<int>(m.joints.size());
  m.bodies.push_back(rotor);
  m.joints.push_back(testing::pin("rotor", kGround, body, 0.0, 0.0));
  m.couplings = {{.name = "gear",
                  .joint_1 = joint,
                  .joint_2 = 0,
                  .ratio = law.ratio,
                  .offset = std::nullopt,
                  .place = "coupling"}};
  law.ratio = 1.0;
  law.rotor_inertia = 0.0;
  m.elements = {testing::on_joint(joint, law)};
  return m;
}

TEST(Motor, ReflectedRotorMovesAsAnOwnOneBehindAGear) {
  const Motion mine = simulate(crank_rocker(false), settings(0.3, 31));
  const Motion own = simulate(crank_rocker(true), settings(0.3, 31));
  double largest = 0.0;
  for (std::size_t i = 0; i < mine.instants.size(); ++i) {
    const Instant &a = mine.instants[i], &b = own.instants[i];
    EXPECT_NEAR(motor_at(a).speed, motor_at(b).speed, 1e-6);
    EXPECT_NEAR(motor_at(a).current_q, motor_at(b).current_q, 1e-7);
    for (std::size_t j = 0; j < 4; ++j) {
      const Vector3d off = a.joints[j].f_W - b.joints[j].f_W;
      // the rotor's own pin is beside the crank's, which the gear does not load
      EXPECT_LT(off.norm(), 1e-7 * (1.0 + b.joints[j].f_W.norm())) << j;
      largest = std::max(largest, a.joints[j].f_W.norm());
    }
    EXPECT_LT(a.power_balance_error, 1e-9);
  }
  EXPECT_GT(largest, 0.1);
  EXPECT_LT(mine.integration->relative_energy_error, 1e-8);
}

// Passes a change point at 0.7 s: its reactions are left open, the motion goes
// on with its energy.
TEST(Motor, PassesAChangePoint) {
  MechanismDefinition m = testing::two_window_four_bar();
  MotorLaw law = published(DirectAxis::kDecoupled);
  law.ratio = 5.0;
  law.volts = {0.0};
  m.elements = {testing::on_joint(0, law)};
  SimulationSettings s = settings(1.0, 11);
  s.at_singularity = AtSingularity::kContinue;
  const Motion motion = simulate(m, s);
  EXPECT_LT(motion.integration->relative_energy_error, 1e-8);
  const MotorState& last = motor_at(motion.instants.back());
  EXPECT_NEAR(last.supplied, last.lost + last.stored + last.given, 1e-9);
}

// 3/2 (n p ψ)² is 96 N m Ω s/rad: over L a spring, over R a damper behind it;
// without R the spring alone, with an L that lets go at once the damper.
TEST(Motor, PushesBackByItsCurrent) {
  MotorLaw law{.ratio = 20.0,
               .pole_pairs = 4,
               .resistance = 0.5,
               .inductance = 5e-3,
               .flux = 0.1};
  const LineTangent both = motor_tangent(law);
  EXPECT_NEAR(both.stiffness, 19200.0, 1e-9 * 19200.0);
  EXPECT_NEAR(both.damping, 192.0, 1e-9 * 192.0);
  EXPECT_TRUE(both.relaxes);
  law.inductance = 4e-5;  // L/R 0.08 ms
  EXPECT_EQ(motor_tangent(law).stiffness, 0.0);
  EXPECT_NEAR(motor_tangent(law).damping, 192.0, 1e-9 * 192.0);
  EXPECT_FALSE(motor_tangent(law).relaxes);
  law.inductance = 5e-3;
  law.resistance = 0.0;
  EXPECT_NEAR(motor_tangent(law).stiffness, 19200.0, 1e-9 * 19200.0);
  EXPECT_FALSE(motor_tangent(law).relaxes);
}

}  // namespace
}  // namespace clevis::mechanism
