#include "mechanism/line_elements/gas_cylinder.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "mechanism/simulate.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

using Eigen::Vector3d;

constexpr double kEnvironment = 101325.0;  // [Pa]
const double kArea = 0.25 * M_PI * 0.015 * 0.015;

/// Piston of 0.6 kg, bore 15 mm, 10 cm³ at x = 0, of the size of
/// [LandingGear] chapter 5.
MechanismDefinition piston(GasCylinderLaw law) {
  MechanismDefinition m = testing::sliders({0.6});
  m.gravity_W = Vector3d::Zero();
  m.elements = {testing::on_joint(0, std::move(law))};
  return m;
}

GasChamber chamber(double pressure) {
  GasChamber result;
  result.name = "cap";
  result.area = kArea;
  result.dead_volume = 1e-5;
  result.start = {pressure, 293.15};
  return result;
}

GasCylinderLaw sealed(double pressure) {
  GasCylinderLaw law;
  law.chambers = {chamber(pressure)};
  return law;
}

GasCylinderLaw supplied(double gauge, int sections) {
  GasCylinderLaw law = sealed(kEnvironment);
  law.supply.pressure = kEnvironment + gauge;
  law.sections = sections;
  GasValve valve;
  valve.orifice.conductance = conductance_of_kv(0.032, 0.3);
  valve.times = {0.0};
  valve.signals = {1.0};
  law.chambers[0].valve = valve;
  return law;
}

void push(MechanismDefinition& m, double force) {
  m.elements.push_back(
      testing::on_joint(0, TableLaw{.times = {0.0}, .efforts = {force}}));
}

/// The published cylinder: stops 0 to 100 mm, damper, opposing load.
MechanismDefinition published(double gauge, int sections, double load) {
  MechanismDefinition m = piston(supplied(gauge, sections));
  m.elements.push_back(testing::on_joint(
      0,
      StopLaw{.lower = 0.0,
              .upper = 0.1,
              .contact = {
                  .stiffness = 1e7, .damping = 1500.0, .transition = 1e-5}}));
  m.elements.push_back(testing::on_joint(0, SpringLaw{.damping = 200.0}));
  push(m, -load);
  return m;
}

SimulationSettings settings(double duration, int instants, double tolerance) {
  SimulationSettings s;
  s.duration = duration;
  s.instants = instants;
  s.tolerance = tolerance;
  return s;
}

const GasChamberState& gas_at(const Instant& instant) {
  return instant.elements[0].chambers[0];
}

double x_at(const Instant& instant) {
  return instant.elements[0].position;
}

/// Keeps the piston where it is.
void hold(MechanismDefinition& m) {
  DriveDefinition held;
  held.joint = 0;
  held.law = DriveLaw::kRamp;
  held.duration = 1.0;
  m.drives = {held};
}

/// When the upper stop is met first.
double arrival(const Motion& motion) {
  for (const MotionEvent& event : motion.events) {
    if (event.what == "press" && event.t > 0.01) return event.t;
  }
  return -1.0;
}

/// Depth at which a stop of 1e7 N/m with 0.01 mm of transition holds a force:
/// (3t² − 2t³) k d = F, t = d/transition.
double depth_under(double force) {
  double low = 0.0, high = 1e-5;
  if (force >= 100.0) return force / 1e7;
  for (int i = 0; i < 100; ++i) {
    const double d = 0.5 * (low + high), t = d / 1e-5;
    (t * t * (3.0 - 2.0 * t) * 1e7 * d < force ? low : high) = d;
  }
  return low;
}

struct Row {
  double gauge, load;
  int sections;
  double duration, known;  ///< time to 100 mm by an independent integration
};

// Cylinders of [LandingGear] chapter 5 by another program's integration, with
// a line where the flow is laminar.
TEST(GasCylinder, FiveRowsOfTheSourceArriveInTime) {
  for (const Row& row :
       {Row{0.1e6, 0.0, 1, 2.0, 1.1585}, Row{0.1e6, 10.0, 1, 4.0, 2.645},
        Row{0.1e6, 0.0, 3, 1.0, 0.419}, Row{10.2e6, 1780.0, 1, 2.0, 1.269},
        Row{3.5e6, 1780.0, 3, 1.0, 0.556}}) {
    const MechanismDefinition m = published(row.gauge, row.sections, row.load);
    const Motion coarse = simulate(m, settings(row.duration, 2, 1e-8));
    const Motion fine = simulate(m, settings(row.duration, 2, 1e-10));
    EXPECT_NEAR(arrival(coarse) / row.known, 1.0, 0.002) << row.known;
    EXPECT_NEAR(arrival(coarse) / arrival(fine), 1.0, 1e-6) << row.known;
    const double force = row.sections * row.gauge * kArea - row.load;
    EXPECT_NEAR(x_at(fine.instants.back()) - 0.1, depth_under(force), 2e-9)
        << row.known;
  }
}

// 17.67 N against 1780 N: the rod stays on its lower stop.
TEST(GasCylinder, PublishedPressureDoesNotLiftThePublishedLoad) {
  const Motion motion =
      simulate(published(0.1e6, 1, 1780.0), settings(1.0, 201, 1e-8));
  for (const Instant& instant : motion.instants) {
    EXPECT_LE(x_at(instant), 0.0);
  }
  const double net = 1780.0 - 0.1e6 * kArea;
  EXPECT_NEAR(x_at(motion.instants.back()), -net / 1e7, 1e-10);
}

TEST(GasCylinder, SealedInsulatedGasKeepsItsAdiabate) {
  MechanismDefinition m = piston(sealed(3e5));
  m.initial_joints = {
      {.joint = 0, .position = 0.04, .rate = {}, .place = "initial"}};
  push(m, -20.0);
  const Motion motion = simulate(m, settings(2.0, 101, 1e-10));
  const double exponent = Gas().isentropic_exponent();
  const auto invariant = [&](const Instant& instant) {
    const GasChamberState& gas = gas_at(instant);
    return gas.pressure * std::pow(gas.volume, exponent);
  };
  double least = 1.0, most = 0.0;
  for (const Instant& instant : motion.instants) {
    EXPECT_NEAR(invariant(instant) / invariant(motion.instants[0]), 1.0, 1e-8);
    least = std::min(least, x_at(instant));
    most = std::max(most, x_at(instant));
  }
  EXPECT_GT(most - least, 0.01);  // it did move
}

TEST(GasCylinder, SealedIsothermalGasKeepsPV) {
  for (const bool by_wall : {false, true}) {
    GasCylinderLaw law = sealed(3e5);
    law.chambers[0].heat =
        by_wall ? ChamberHeat::kConducting : ChamberHeat::kIsothermal;
    law.chambers[0].wall_conductance = by_wall ? 1e10 : 0.0;
    MechanismDefinition m = piston(law);
    m.initial_joints = {
        {.joint = 0, .position = 0.04, .rate = {}, .place = "initial"}};
    push(m, -20.0);
    const Motion motion = simulate(m, settings(1.0, 51, 1e-10));
    const GasChamberState& first = gas_at(motion.instants[0]);
    for (const Instant& instant : motion.instants) {
      const GasChamberState& gas = gas_at(instant);
      EXPECT_NEAR(gas.pressure * gas.volume / (first.pressure * first.volume),
                  1.0, 1e-8)
          << by_wall;
    }
  }
}

// k = γ p A²/V: 6.10 Hz at 0.2 MPa, 43.3 Hz at what holds 1780 N.
TEST(GasCylinder, GasSpringHasItsFrequency) {
  for (const auto& [pressure, known] :
       {std::pair{kEnvironment + 1e5, 6.10},
        std::pair{kEnvironment + 1780.0 / kArea, 43.3}}) {
    const double k =
        Gas().isentropic_exponent() * pressure * kArea * kArea / 1e-5;
    const double frequency = std::sqrt(k / 0.6) / (2.0 * M_PI);
    EXPECT_NEAR(frequency / known, 1.0, 2e-3);
    MechanismDefinition m = piston(sealed(pressure));
    const double a = 2e-5;
    m.initial_joints = {{.joint = 0,
                         .position = 0.0,
                         .rate = a * 2.0 * M_PI * frequency,
                         .place = "initial"}};
    push(m, -(pressure - kEnvironment) * kArea);
    const Motion motion = simulate(m, settings(10.0 / frequency, 2, 1e-11));
    EXPECT_NEAR(x_at(motion.instants.back()), 0.0, 3e-3 * a) << known;
    EXPECT_GT(motion.instants.back().elements[0].rate, 0.0);
  }
}

TEST(GasCylinder, MassIsInBalanceToRoundOff) {
  const Motion motion =
      simulate(published(0.1e6, 3, 0.0), settings(0.5, 51, 1e-6));
  const double first = gas_at(motion.instants[0]).mass;
  for (const Instant& instant : motion.instants) {
    const GasChamberState& gas = gas_at(instant);
    EXPECT_NEAR(gas.mass, first + gas.taken - gas.released, 1e-14 * gas.mass);
    EXPECT_NEAR(gas.mass, gas.pressure * gas.volume / 287.0 / gas.temperature,
                1e-14 * gas.mass);
  }
}

// Held by a drive: choked filling is linear, and its energy c_p T.
TEST(GasCylinder, ChokedFillingOfAHeldChamberIsLinearInTime) {
  GasCylinderLaw law = supplied(10e6, 1);
  law.chambers[0].valve->leakage = 0.0;
  MechanismDefinition m = piston(law);
  hold(m);
  const Motion motion = simulate(m, settings(0.013, 11, 1e-10));
  const double p = kEnvironment + 10e6;
  const double flow = conductance_of_kv(0.032, 0.3) * 1.185 * p;
  const GasChamberState& start = gas_at(motion.instants[0]);
  const double exponent = Gas().isentropic_exponent();
  for (const Instant& instant : motion.instants) {
    const GasChamberState& gas = gas_at(instant);
    ASSERT_LT(gas.pressure, 0.3 * p);
    EXPECT_NEAR(gas.taken, flow * instant.t,
                1e-12 * start.mass + 1e-9 * gas.taken);
    EXPECT_NEAR(gas.pressure,
                start.pressure + exponent * 287.0 * 293.15 * gas.taken / 1e-5,
                1e-9 * gas.pressure);
  }
}

// A ramp from 2 to 6 ms, then open: flow times the opening's integral.
TEST(GasCylinder, ValveFollowsItsOpening) {
  GasCylinderLaw law = supplied(10e6, 1);
  GasValve& valve = *law.chambers[0].valve;
  valve.leakage = valve.smoothing = 0.0;
  valve.times = {0.002, 0.006};
  valve.signals = {0.0, 1.0};
  MechanismDefinition m = piston(law);
  hold(m);
  const Motion motion = simulate(m, settings(0.012, 13, 1e-10));
  const double flow = valve.orifice.conductance * 1.185 * (kEnvironment + 10e6);
  for (const Instant& instant : motion.instants) {
    const double ramp = std::clamp(instant.t - 0.002, 0.0, 0.004);
    const double open =
        0.5 * ramp * ramp / 0.004 + std::max(0.0, instant.t - 0.006);
    EXPECT_NEAR(gas_at(instant).taken, flow * open, 1e-9 * flow * 0.01)
        << instant.t;
  }
}

// Choked and isothermal: m' = −m/τ, τ = V/(R T C ρ₀) at T = T₀.
TEST(GasCylinder, ExhaustOfAHeldIsothermalChamberDecaysExponentially) {
  GasCylinderLaw law = supplied(1e6, 1);
  law.chambers[0].start.pressure = 1e6;
  law.chambers[0].heat = ChamberHeat::kIsothermal;
  law.chambers[0].valve->leakage = 0.0;
  law.chambers[0].valve->signals = {-1.0};
  MechanismDefinition m = piston(law);
  hold(m);
  const Motion motion = simulate(m, settings(0.06, 7, 1e-10));
  const double tau =
      1e-5 / (287.0 * 293.15 * conductance_of_kv(0.032, 0.3) * 1.185);
  for (const Instant& instant : motion.instants) {
    ASSERT_GT(0.3 * gas_at(instant).pressure, kEnvironment);
    EXPECT_NEAR(gas_at(instant).pressure, 1e6 * std::exp(-instant.t / tau),
                1e-9 * 1e6);
    EXPECT_EQ(gas_at(instant).taken, 0.0);
  }
}

// Two chambers that mirror one another hold the piston in the middle.
TEST(GasCylinder, ChambersOfBothSensesBalance) {
  GasCylinderLaw law = sealed(4e5);
  law.chambers.push_back(law.chambers[0]);
  law.chambers[1].name = "rod";
  law.chambers[1].sense = -1.0;
  const Motion motion = simulate(piston(law), settings(0.5, 3, 1e-10));
  EXPECT_NEAR(x_at(motion.instants.back()), 0.0, 1e-12);
  // and spring back with twice the stiffness of one
  MechanismDefinition m = piston(law);
  const double k =
      2.0 * Gas().isentropic_exponent() * 4e5 * kArea * kArea / 1e-5;
  const double w = std::sqrt(k / 0.6), a = 2e-5;
  m.initial_joints = {
      {.joint = 0, .position = 0.0, .rate = a * w, .place = "initial"}};
  const Motion swing = simulate(m, settings(2.0 * M_PI / w * 10.25, 2, 1e-11));
  EXPECT_NEAR(x_at(swing.instants.back()), a, 1e-3 * a);
}

TEST(GasCylinder, RefusesAChamberWithoutVolumeAndAMotionThatDrivesFix) {
  MechanismDefinition m = piston(sealed(2e5));
  m.initial_joints = {
      {.joint = 0, .position = -0.06, .rate = {}, .place = "initial"}};
  const auto code_of = [](const MechanismDefinition& definition,
                          const SimulationSettings& s) {
    try {
      simulate(definition, s);
    } catch (const Error& error) {
      return std::string(error.code());
    }
    return std::string();
  };
  EXPECT_EQ(code_of(m, settings(1.0, 2, 1e-8)), "K009");
  SimulationSettings driven = settings(1.0, 2, 1e-8);
  driven.motion = MotionKind::kDriven;
  EXPECT_EQ(code_of(piston(sealed(2e5)), driven), "K002");
}

}  // namespace
}  // namespace clevis::mechanism
