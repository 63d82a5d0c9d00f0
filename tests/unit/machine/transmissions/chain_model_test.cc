#include "machine/transmissions/chain_model.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "machine/transmissions/transmission.h"

namespace clevis::machine {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

TEST(ChainModel, OfTwoMassesIsTheTwoMassModel) {
  const TwoMassModel two = two_mass_model(3e-3, 0.02, 1e-3);
  const ChainModel chain = chain_model({3e-3, 0.02}, {1e-3});
  ASSERT_EQ(chain.resonances.size(), 1u);
  ASSERT_EQ(chain.antiresonances.size(), 1u);
  EXPECT_NEAR(chain.resonances[0] / two.resonance, 1.0, 1e-14);
  EXPECT_NEAR(chain.antiresonances[0] / two.antiresonance, 1.0, 1e-14);
}

// Equal masses and springs: ω² = k/J and 3 k/J free, (3 ∓ √5)/2 k/J held.
TEST(ChainModel, OfThreeEqualMassesHasItsClosedForm) {
  const double J = 2e-3, e = 5e-4, unit = 1.0 / std::sqrt(J * e) / kTurn;
  const ChainModel chain = chain_model({J, J, J}, {e, e});
  ASSERT_EQ(chain.resonances.size(), 2u);
  EXPECT_NEAR(chain.resonances[0] / unit, 1.0, 1e-13);
  EXPECT_NEAR(chain.resonances[1] / unit, std::sqrt(3.0), 1e-13);
  ASSERT_EQ(chain.antiresonances.size(), 2u);
  EXPECT_NEAR(chain.antiresonances[0] / unit,
              std::sqrt((3.0 - std::sqrt(5.0)) / 2.0), 1e-13);
  EXPECT_NEAR(chain.antiresonances[1] / unit,
              std::sqrt((3.0 + std::sqrt(5.0)) / 2.0), 1e-13);
}

// What has no inertia, or does not yield, is no mass of its own.
TEST(ChainModel, LeavesOutMassesOfZeroAndRigidSprings) {
  const ChainModel plain = chain_model({1e-3, 2e-3}, {7e-4});
  const ChainModel split =
      chain_model({0.4e-3, 0.6e-3, 0.0, 2e-3}, {0.0, 3e-4, 4e-4});
  ASSERT_EQ(split.resonances.size(), 1u);
  EXPECT_NEAR(split.resonances[0] / plain.resonances[0], 1.0, 1e-14);
  const ChainModel rigid = chain_model({1e-3, 2e-3}, {0.0});
  EXPECT_TRUE(rigid.resonances.empty());
  EXPECT_TRUE(rigid.antiresonances.empty());
}

// Cut fine, it is a shaft with its own inertia: free ends turn against one
// another with half a wave on its length.
TEST(ChainModel, OfManySlicesIsAShaft) {
  constexpr int n = 400;
  constexpr double kJ = 1e-3, kE = 1e-3;  // of the whole shaft
  std::vector<double> inertias(n + 1, kJ / n), compliances(n, kE / n);
  inertias.front() = inertias.back() = 0.5 * kJ / n;
  const ChainModel chain = chain_model(inertias, compliances);
  EXPECT_NEAR(chain.resonances[0] * 2.0 * std::sqrt(kJ * kE), 1.0, 1e-5);
  EXPECT_NEAR(chain.antiresonances[0] * 4.0 * std::sqrt(kJ * kE), 1.0, 1e-5);
}

// Rayleigh: the energy of wheels lowers the antiresonance of the two-mass
// model, at ratios the inertia counts by their square.
TEST(ChainModel, OfATransmissionCountsWheelsByTheSquareOfTheRatio) {
  TransmissionDefinition t;
  t.stages = {{"one", 3.0, true, {{"", GivenCompliance{1e-4, true}, ""}}},
              {"two", 1.0, true, {{"", GivenCompliance{1e-3, true}, ""}}}};
  t.motor_inertia = 1e-4;
  t.load_inertia = 0.02;
  EXPECT_FALSE(analyse_transmission(t).chain);
  t.stages[0].pinion_inertia = 2e-5;
  t.stages[1].wheel_inertia = 9.0 * 3e-5;
  const TransmissionResult result = analyse_transmission(t);
  ASSERT_TRUE(result.chain);
  // two springs, the motor held: det of a 2 × 2 by hand
  const double k1 = 9.0 / 1e-4, k2 = 1.0 / 1e-3, J = 9.0 * 5e-5, load = 0.02;
  const double b = (k1 + k2) / J + k2 / load, c = k1 * k2 / (J * load);
  const double first = std::sqrt(0.5 * (b - std::sqrt(b * b - 4.0 * c)));
  EXPECT_NEAR(result.chain->antiresonances[0] * kTurn / first, 1.0, 1e-12);
  EXPECT_LT(result.chain->antiresonances[0], result.two_mass->antiresonance);
}

}  // namespace
}  // namespace clevis::machine
