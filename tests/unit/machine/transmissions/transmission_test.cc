#include "machine/transmissions/transmission.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

namespace clevis::machine {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// Stages of one given compliance each, rad/(N m).
TransmissionDefinition chain(const std::vector<double>& compliances,
                             const std::vector<double>& ratios) {
  TransmissionDefinition t;
  t.name = "chain";
  for (std::size_t i = 0; i < compliances.size(); ++i) {
    TransmissionStage stage;
    stage.ratio = i < ratios.size() ? ratios[i] : 1.0;
    stage.elements = {{"", GivenCompliance{compliances[i], true}, ""}};
    t.stages.push_back(stage);
  }
  return t;
}

// (5.73): e_n = Σ e_i / u_in². The torque T on the output is T/u on a stage;
// the energy is the same, whichever shaft one looks from.
TEST(Transmission, ReducesByTheEnergyOfAllStages) {
  const std::vector<double> e{2e-4, 5e-4, 1e-3}, u{3.0, 2.0};
  const auto result = analyse_transmission(chain(e, u));
  const double T = 7.0;
  const double energy = 0.5 * (e[0] * std::pow(T / 6.0, 2) +
                               e[1] * std::pow(T / 2.0, 2) + e[2] * T * T);
  EXPECT_NEAR(0.5 * result.compliance * T * T / energy, 1.0, 1e-14);
  EXPECT_EQ(result.ratio, 6.0);
  EXPECT_EQ(result.last_stage, e[2]);
}

// Shafts of equal length and stress, d ~ T^(1/3): the whole is 2.03, 1.68 and
// 1.46 times the last shaft, not the 1 of the source's rule; of equal
// compliances 1.31, 1.11, 1.04.
TEST(Transmission, LastStageAloneIsNotEnough) {
  const std::vector<std::array<double, 3>> rows{
      {2.0, 2.03, 1.31}, {std::sqrt(10.0), 1.68, 1.11}, {5.0, 1.46, 1.04}};
  for (const auto& [u, equal_stress, equal_compliance] : rows) {
    TransmissionDefinition t = chain({1.0, 1.0, 1.0}, {u, u});
    const auto equal = analyse_transmission(t);
    EXPECT_NEAR(equal.compliance / equal.last_stage, equal_compliance, 0.005);
    double diameter = 0.01;
    for (auto& stage : t.stages) {
      stage.elements[0].law = Shaft{0.05, diameter, 0.0, 8.1e10};
      diameter *= std::cbrt(u);
    }
    const auto sized = analyse_transmission(t);
    EXPECT_NEAR(sized.compliance / sized.last_stage, equal_stress, 0.005);
  }
}

// Teeth seen from the driving or the driven wheel are the same teeth.
TEST(Transmission, TeethMayStandOnEitherWheel) {
  TransmissionDefinition driving = chain({1e-5, 1e-5}, {3.0});
  TransmissionDefinition driven = driving;
  driving.stages[0].elements.push_back(
      {"", GearTeeth{0.02, 0.015, 1.45e10}, ""});
  driven.stages[1].elements.push_back(
      {"", GearTeeth{0.06, 0.015, 1.45e10}, ""});
  const auto one = analyse_transmission(driving);
  const auto two = analyse_transmission(driven);
  EXPECT_NEAR(one.compliance / two.compliance, 1.0, 1e-14);
  EXPECT_NEAR(one.last_stage / two.last_stage, 1.0, 1e-14);
  // (5.76) as printed forgets that of the driving wheel
  const double teeth = 1.0 / (1.45e10 * 0.02 * 0.02 * 0.015);
  EXPECT_NEAR(one.last_stage_published - one.last_stage,
              teeth * (1.0 - 1.0 / 9.0), 1e-16);
  EXPECT_EQ(two.last_stage_published, two.last_stage);
}

// A screw of lead L: F pushes with the torque F L/2π, an angle φ moves φ L/2π.
TEST(Transmission, LeadJoinsTurningAndSliding) {
  constexpr double kLead = 0.005, e_screw = 1e-4, e_table = 4e-9;
  TransmissionDefinition t = chain({e_screw, 0.0}, {kTurn / kLead});
  t.stages[1].angular = false;
  t.stages[1].elements = {{"", GivenCompliance{e_table, false}, ""}};
  const auto result = analyse_transmission(t);
  const double F = 500.0;
  const double slide = F * kLead / kTurn * e_screw * kLead / kTurn;
  EXPECT_NEAR(result.compliance * F, slide + F * e_table, 1e-18);
  EXPECT_FALSE(result.angular);
}

// Natural frequencies by the eigenvalues of K and M of motor and load, before
// reduction: motor angle u times that of the output.
TEST(Transmission, TwoMassFrequenciesAreThoseOfTheEigenproblem) {
  TransmissionDefinition t = chain({1e-3, 2e-3}, {4.0});
  t.motor_inertia = 3e-4;
  t.load_inertia = 0.02;
  const auto result = analyse_transmission(t);
  const double u = 4.0, k = 1.0 / result.compliance;
  Eigen::Matrix2d K, M;  // of (motor angle, load angle)
  K << k / (u * u), -k / u, -k / u, k;
  M << 3e-4, 0.0, 0.0, 0.02;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d> modes(K, M);
  EXPECT_NEAR(kTurn * result.two_mass->resonance,
              std::sqrt(modes.eigenvalues()[1]), 1e-9);
  EXPECT_NEAR(modes.eigenvalues()[0], 0.0, 1e-9);
  EXPECT_NEAR(kTurn * result.two_mass->antiresonance, std::sqrt(k / 0.02),
              1e-9);
}

TEST(Transmission, PublishedUnitOfBallScrewsIsAChoice) {
  TransmissionDefinition t = chain({1.0}, {});
  t.stages[0].angular = false;
  t.stages[0].elements = {{"", BallScrew{0.02, 0.003, 3.0, 500.0, 1.0}, ""}};
  const auto corrected = analyse_transmission(t);
  t.ball_screw_unit = BallScrewUnit::kPublished;
  const auto published = analyse_transmission(t);
  EXPECT_EQ(corrected.compliance, published.compliance_other_unit);
  EXPECT_EQ(published.compliance, corrected.compliance_other_unit);
  EXPECT_NEAR(published.compliance / corrected.compliance, 1000.0, 1e-9);
}

}  // namespace
}  // namespace clevis::machine
