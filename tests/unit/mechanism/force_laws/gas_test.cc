#include "mechanism/force_laws/gas.h"

#include <cmath>

#include <gtest/gtest.h>

namespace clevis::mechanism {
namespace {

const Gas kAir;
const Orifice kValve{.conductance = 1.528e-9};

double flow(double p_1, double p_2, double T = 293.15) {
  return orifice_flow(kValve, kAir, {p_1, T}, {p_2, T}).mass;
}

TEST(Gas, ChokedFlowIsProportionalToThePressureBeforeTheOrifice) {
  const double choked = 1.528e-9 * 1.185 * 2e5;
  EXPECT_NEAR(flow(2e5, 1e4), choked, 1e-15 * choked);
  EXPECT_NEAR(flow(2e5, 0.3 * 2e5), choked, 1e-15 * choked);
  EXPECT_NEAR(flow(2e5, 1e4, 4.0 * 293.15), 0.5 * choked, 1e-15);
}

TEST(Gas, SubsonicFlowIsTheEllipse) {
  const double choked = 1.528e-9 * 1.185 * 2e5;
  for (const double r : {0.35, 0.65, 0.9, 0.998}) {
    const double s = (r - 0.3) / 0.7;
    EXPECT_NEAR(flow(2e5, r * 2e5), choked * std::sqrt(1.0 - s * s),
                1e-14 * choked);
  }
}

TEST(Gas, FlowIsSmoothWhereItTurnsAndWhereItsLawsMeet) {
  const auto slope = [](double r, double h) {
    return (flow(2e5, 2e5 * (r + h)) - flow(2e5, 2e5 * r)) / h;
  };
  for (const double r : {0.3, 0.999}) {
    const double size = std::abs(slope(0.999, -1e-7));
    EXPECT_NEAR(slope(r, 1e-8), slope(r, -1e-8), 1e-4 * size) << r;
  }
  // odd in the difference of pressures where temperatures are equal
  EXPECT_DOUBLE_EQ(flow(1e5, 0.9999e5), -flow(0.9999e5, 1e5));
  EXPECT_NEAR(flow(1e5, 1e5 - 1.0) / flow(1e5 - 1.0, 1e5), -1.0, 1e-12);
  EXPECT_EQ(flow(1e5, 1e5), 0.0);
}

TEST(Gas, EnthalpyComesFromWhereTheGasComesFrom) {
  const GasState hot{2e5, 400.0}, cold{1e5, 250.0};
  const GasFlow out = orifice_flow(kValve, kAir, hot, cold);
  EXPECT_DOUBLE_EQ(out.enthalpy, out.mass * 1005.0 * 400.0);
  const GasFlow back = orifice_flow(kValve, kAir, cold, hot);
  EXPECT_DOUBLE_EQ(back.mass, -out.mass);
  EXPECT_DOUBLE_EQ(back.enthalpy, -out.enthalpy);
}

TEST(Gas, ConductancesAreThoseOfTheSameFlow) {
  EXPECT_NEAR(conductance_of_kv(0.032, 0.3), 1.528e-9, 5e-13);
  EXPECT_DOUBLE_EQ(conductance_of_cv(2.0, 0.3), conductance_of_kv(1.73, 0.3));
  // water's law with the gas's density, at a drop of 1e-6 of the pressure
  const double b = 0.3, p = 5e5, drop = 0.5, density = 1.185 * 5.0;
  const Orifice root{conductance_of_kv(1.0, b), b, 1.0 - 1e-8};
  const double expected = std::sqrt(1000.0 / 1e5 * density * drop) / 3600.0;
  EXPECT_NEAR(
      orifice_flow(root, kAir, {p, 293.15}, {p - drop, 293.15}).mass / expected,
      1.0, 1e-5);
  // textbook: air through 1 m² at 1 bar, 20 °C: 0.6847 p/sqrt(R T)
  EXPECT_NEAR(conductance_of_area(1.0, 1.0, {287.0, 1004.5}) * 1.185 *
                  std::sqrt(287.0 * 293.15),
              0.68473, 1e-5);
}

TEST(Gas, AValveOpensFullyAndShutsFully) {
  EXPECT_EQ(valve_opening(-0.3, 0.01), 0.0);
  EXPECT_EQ(valve_opening(0.0, 0.01), 0.0);
  EXPECT_EQ(valve_opening(1.0, 0.01), 1.0);
  EXPECT_EQ(valve_opening(1.7, 0.01), 1.0);
  EXPECT_DOUBLE_EQ(valve_opening(0.5, 0.01), 0.5);
  EXPECT_EQ(valve_opening(0.25, 0.0), 0.25);
  for (const double s : {0.0, 0.01, 0.99, 1.0}) {
    const double h = 1e-7;
    EXPECT_NEAR((valve_opening(s + h, 0.01) - valve_opening(s, 0.01)) / h,
                (valve_opening(s, 0.01) - valve_opening(s - h, 0.01)) / h, 1e-4)
        << s;
  }
}

TEST(Gas, ContentAndStateAreInverse) {
  const GasState state{3e5, 310.0};
  const ChamberContent content = chamber_content(kAir, state, 2e-5);
  EXPECT_NEAR(content.mass, 3e5 * 2e-5 / (287.0 * 310.0), 1e-18);
  const GasState back = chamber_state(kAir, content, 2e-5);
  EXPECT_DOUBLE_EQ(back.pressure, 3e5);
  EXPECT_DOUBLE_EQ(back.temperature, 310.0);
}

TEST(Gas, AChamberWithoutVolumeOrGasHasNoState) {
  EXPECT_TRUE(std::isnan(chamber_state(kAir, {1e-5, 1.0}, 0.0).pressure));
  EXPECT_TRUE(std::isnan(chamber_state(kAir, {0.0, 1.0}, 1e-5).pressure));
  EXPECT_TRUE(std::isnan(chamber_state(kAir, {1e-5, -1.0}, 1e-5).temperature));
}

// p V^γ is constant: d ln p = d ln U − d ln V by the rates.
TEST(Gas, RatesOfASealedInsulatedChamberKeepTheAdiabate) {
  const double V = 1e-5, V_rate = 3e-4;
  const GasState state{2e5, 293.15};
  const ChamberContent content = chamber_content(kAir, state, V);
  const ChamberContent rate = chamber_rates(state, {}, V_rate, 0.0);
  EXPECT_EQ(rate.mass, 0.0);
  const double p_rate = rate.energy / content.energy - V_rate / V;
  EXPECT_NEAR(p_rate, -kAir.isentropic_exponent() * V_rate / V, 1e-12);
}

// Filling a rigid insulated vessel from a reservoir: p' = γ R T m'/V.
TEST(Gas, RatesOfFillingAreThoseOfTheReservoirsEnthalpy) {
  const GasState vessel{1e5, 280.0};
  const GasFlow in =
      orifice_flow(kValve, kAir, {1e6, 300.0}, {vessel.pressure, 280.0});
  const ChamberContent rate = chamber_rates(vessel, in, 0.0, 0.0);
  const double p_rate = kAir.gas_constant / kAir.c_v() * rate.energy / 2e-5;
  const double k = kAir.isentropic_exponent();
  EXPECT_NEAR(p_rate / (k * 287.0 * 300.0 * in.mass / 2e-5), 1.0, 1e-14);
}

}  // namespace
}  // namespace clevis::mechanism
