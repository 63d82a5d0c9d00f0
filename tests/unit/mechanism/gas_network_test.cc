// More than a cylinder of two chambers on endless supply: chambers in tandem, a
// tank that empties, gas that communicates with the mechanism in steps.
#include <cmath>

#include <gtest/gtest.h>

#include "mechanism/line_elements/gas_cylinder.h"
#include "mechanism/simulate.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

constexpr double kEnvironment = 101325.0;  // [Pa]

GasChamber fed(const char* name) {
  GasChamber chamber;
  chamber.name = name;
  chamber.area = 1.767e-4;
  chamber.dead_volume = 1e-5;
  chamber.start = {kEnvironment, 293.15};
  chamber.valve = GasValve{
      .orifice = {.conductance = 1.528e-9}, .times = {0.0}, .signals = {1.0}};
  return chamber;
}

GasCylinderLaw supplied(double gauge) {
  GasCylinderLaw law;
  law.supply.pressure = kEnvironment + gauge;
  law.chambers = {fed("cap")};
  return law;
}

GasCylinderLaw from_tank(GasCylinderLaw law, double volume) {
  GasChamber tank;
  tank.name = "supply";
  tank.dead_volume = volume;
  tank.start = law.supply;
  law.chambers.push_back(tank);
  law.has_tank = true;
  return law;
}

MechanismDefinition piston(GasCylinderLaw law, double damping = 200.0) {
  MechanismDefinition m = testing::sliders({0.6});
  m.gravity_W.setZero();
  m.elements = {testing::on_joint(0, std::move(law)),
                testing::on_joint(0, SpringLaw{.damping = damping})};
  return m;
}

SimulationSettings settings(double duration, int instants) {
  SimulationSettings s;
  s.duration = duration;
  s.instants = instants;
  s.tolerance = 1e-10;
  return s;
}

const Instant last_of(const MechanismDefinition& m, double duration) {
  return simulate(m, settings(duration, 2)).instants.back();
}

TEST(GasNetwork, PistonsInTandemAddTheirForces) {
  GasCylinderLaw tandem = supplied(1e5), sections = supplied(1e5);
  tandem.chambers = {fed("one"), fed("two"), fed("three")};
  sections.sections = 3;
  const Instant one = last_of(piston(tandem), 0.2);
  const Instant other = last_of(piston(sections), 0.2);
  EXPECT_NEAR(one.elements[0].position, other.elements[0].position, 1e-11);
  EXPECT_GT(one.elements[0].position, 0.02);
  ASSERT_EQ(one.elements[0].chambers.size(), 3u);
  EXPECT_NEAR(one.elements[0].chambers[2].pressure,
              other.elements[0].chambers[0].pressure, 1e-3);
}

// Insulated: the energy p V/(γ − 1) of both stays.
TEST(GasNetwork, TankAndHeldChamberMeetAtTheMeanPressure) {
  GasCylinderLaw law = from_tank(supplied(9e5), 4e-5);
  law.chambers[0].valve->leakage = 0.0;
  law.sections = 3;
  MechanismDefinition m = piston(law);
  DriveDefinition held;
  held.joint = 0;
  held.law = DriveLaw::kConstant;
  m.drives = {held};
  const Motion motion = simulate(m, settings(0.5, 11));
  const auto& first = motion.instants.front().elements[0].chambers;
  const auto& last = motion.instants.back().elements[0].chambers;
  const double mean =
      ((kEnvironment + 9e5) * 4e-5 + 3.0 * kEnvironment * 1e-5) / 7e-5;
  EXPECT_NEAR(last[0].pressure, mean, 1e-6 * mean);
  EXPECT_NEAR(last[1].pressure, mean, 1e-6 * mean);
  EXPECT_NEAR(first[1].mass - last[1].mass, 3.0 * last[0].taken, 1e-15);
  EXPECT_NEAR(last[1].released, 3.0 * last[0].taken, 1e-15);
  EXPECT_LT(last[1].temperature, 293.15);
  EXPECT_GT(last[0].temperature, 293.15);
}

TEST(GasNetwork, LargeTankIsAnEndlessSupply) {
  const Instant endless = last_of(piston(supplied(1e5)), 0.3);
  const Instant large = last_of(piston(from_tank(supplied(1e5), 1e3)), 0.3);
  const Instant small = last_of(piston(from_tank(supplied(1e5), 1e-5)), 0.3);
  EXPECT_NEAR(large.elements[0].position, endless.elements[0].position, 1e-9);
  EXPECT_LT(small.elements[0].position, 0.9 * endless.elements[0].position);
}

/// What the steps of the communication change by the end.
struct Coupled {
  double off{};    ///< of the position
  double drift{};  ///< of the energy
  double gap{};    ///< of the gas's own position
};

Coupled coupled(double step) {
  GasCylinderLaw law = supplied(1e5);
  const double known = last_of(piston(law), 0.3).elements[0].position;
  law.step = step;
  const Instant last = last_of(piston(law), 0.3);
  const GasInterface& interface = *last.elements[0].interface;
  return {last.elements[0].position - known,
          interface.work_on_mechanism - interface.work_of_gas,
          interface.gas_q - last.elements[0].position};
}

TEST(CoupledGas, ErrorsFallWithTheStep) {
  const Coupled coarse = coupled(2e-3), fine = coupled(1e-3);
  EXPECT_NEAR(coarse.off / fine.off, 2.0, 0.15);
  // its first order cancels where a damper holds the piston
  EXPECT_GT(std::abs(coarse.drift), 2.0 * std::abs(fine.drift));
  EXPECT_NEAR(coarse.gap / fine.gap, 2.0, 0.15);
  EXPECT_GT(std::abs(fine.off), 1e-6);  // it is another motion
  EXPECT_LT(std::abs(fine.off), 1e-3);
}

// Each side's books are in order: mass to round-off, the gas's energy by what
// came in and the work at the rate that it was told.
TEST(CoupledGas, KeepsMassAndTheGasItsOwnEnergy) {
  GasCylinderLaw law = supplied(1e5);
  law.step = 5e-3;
  law.chambers[0].valve->leakage = 0.0;
  const Motion motion = simulate(piston(law), settings(0.1, 21));
  const auto& first = motion.instants.front().elements[0].chambers[0];
  const auto& last = motion.instants.back().elements[0];
  const GasChamberState& gas = last.chambers[0];
  EXPECT_NEAR(gas.mass, first.mass + gas.taken, 1e-14 * gas.mass);
  const double c_v = 718.0, c_p = 1005.0;
  const double pushed = kEnvironment * (gas.volume - first.volume);
  EXPECT_NEAR(
      gas.mass * c_v * gas.temperature - first.mass * c_v * first.temperature,
      gas.taken * c_p * 293.15 - last.interface->work_of_gas - pushed, 1e-8);
  EXPECT_LT(motion.integration->relative_energy_error, 1e-8);
}

// Both sides lag by half a step: the spring k of sealed gas gets the damper
// −k h, and a piston without another one swells.
TEST(CoupledGas, SwellsWithoutADamper) {
  GasCylinderLaw law;
  law.chambers = {fed("cap"), fed("rod")};
  for (GasChamber& chamber : law.chambers) {
    chamber.start.pressure = 4e5;
    chamber.valve.reset();
  }
  law.chambers[1].sense = -1.0;
  const double area = law.chambers[0].area;
  const double k = 2.0 * Gas().isentropic_exponent() * 4e5 * area * area / 1e-5;
  const double w = std::sqrt(k / 0.6), end = 6.25 * 2.0 * M_PI / w;
  const auto after = [&](double step) {
    law.step = step;
    MechanismDefinition m = piston(law, 0.0);
    m.initial_joints = {
        {.joint = 0, .position = 0.0, .rate = 1e-4 * w, .place = "initial"}};
    return last_of(m, end).elements[0].position / 1e-4;
  };
  EXPECT_NEAR(after(0.0), 1.0, 1e-4);
  // the gas knows the first rate from the start: it is h v₀/2 ahead for good
  const double grown = k * 2e-4 * end / (2.0 * 0.6);
  EXPECT_NEAR(after(2e-4), std::exp(grown) - 0.5 * 2e-4 * w, 5e-4);
  EXPECT_GT(grown, 0.25);
}

}  // namespace
}  // namespace clevis::mechanism
