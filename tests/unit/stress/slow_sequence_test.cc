#include "stress/peaks/slow_sequence.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace clevis::stress {
namespace {

constexpr int kDofs[] = {200, 700, 1700, 3300};

/// 1 − N^(−rate) · size of degrees 1, 2 … and twice its half as energy.
std::vector<DisplacementValue> algebraic(double rate, double size,
                                         std::size_t count = 3) {
  std::vector<DisplacementValue> sequence;
  for (std::size_t k = 0; k < count; ++k) {
    const double value = 1.0 - size * std::pow(kDofs[k], -rate);
    sequence.push_back({static_cast<int>(k) + 1, kDofs[k], value, 0.5 * value});
  }
  return sequence;
}

// Singular corners and nearly incompressible material: errors go like a power
// of the number of unknowns, and the last change is a fraction of what is left.
TEST(SlowSequence, ErrorOfAPowerIsCovered) {
  for (const double rate : {0.15, 0.3, 0.6, 1.0}) {
    const auto sequence = algebraic(rate, 0.3);
    const double true_error = 1.0 / sequence.back().value - 1.0;
    const double error = displacement_error(sequence);
    EXPECT_GT(error, true_error) << rate;
    EXPECT_LT(error, 4.0 * true_error) << rate;
  }
}

// A displacement may fall where the energy rises.
TEST(SlowSequence, FallsLikeItRises) {
  auto sequence = algebraic(0.3, 0.3);
  for (auto& one : sequence) one.value = 2.0 - one.value;
  const double true_error = 1.0 - 1.0 / sequence.back().value;
  EXPECT_GT(displacement_error(sequence), true_error);
  EXPECT_LT(displacement_error(sequence), 4.0 * true_error);
}

// The displacement hardly moves by chance, the energy tells.
TEST(SlowSequence, EnergyTellsWhereTheDisplacementStandsStill) {
  auto sequence = algebraic(0.3, 0.3);
  const double true_error = 0.5 / sequence.back().energy - 1.0;
  for (auto& one : sequence) one.value = 1.0;
  EXPECT_GT(displacement_error(sequence), true_error);
}

TEST(SlowSequence, FastOnesAreNotWidened) {
  std::vector<DisplacementValue> sequence;
  for (int k = 0; k < 4; ++k) {
    const double value = 1.0 - std::pow(10.0, -k - 1);
    sequence.push_back({k + 1, kDofs[k], value, 0.5 * value});
  }
  const double error = displacement_error(sequence);
  EXPECT_GT(error, 1e-4);
  EXPECT_LT(error, 1.5e-3);  // one and a half of the last change, 9e-4
}

TEST(SlowSequence, TwoValuesTellLittle) {
  const std::vector<DisplacementValue> two{{1, 200, 0.8, 0.4},
                                           {2, 700, 1.0, 0.5}};
  EXPECT_NEAR(displacement_error(two), 4.0 * 0.2, 1e-12);
  EXPECT_EQ(displacement_error(algebraic(0.3, 0.3, 1)), 1.0);
  EXPECT_EQ(displacement_error({}), 1.0);
}

}  // namespace
}  // namespace clevis::stress
