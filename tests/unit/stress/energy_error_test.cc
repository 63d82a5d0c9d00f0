#include "stress/peaks/energy_error.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace clevis::stress {
namespace {

TEST(EnergyError, IsExactForAPowerOfTheDegreesOfFreedom) {
  for (const double power : {0.5, 1.1, 3.0}) {
    std::vector<EnergyValue> sequence;
    for (const int dofs : {100, 340, 720, 1230}) {
      sequence.push_back({dofs, 5.0 - 2.0 * std::pow(dofs / 100.0, -power)});
    }
    const double energy = sequence.back().energy;
    EXPECT_NEAR(strain_energy_error(sequence), (5.0 - energy) / energy,
                1e-8 * (5.0 - energy))
        << power;
  }
}

// Fewer than nothing is missing, or the changes grow: the last one.
TEST(EnergyError, OfUnsettledEnergiesIsTheLastChange) {
  const std::vector<EnergyValue> falling = {{10, 4.0}, {20, 5.0}, {30, 4.9}};
  EXPECT_NEAR(strain_energy_error(falling), 0.1 / 4.9, 1e-12);
  const std::vector<EnergyValue> growing = {{10, 1.0}, {20, 1.1}, {21, 2.0}};
  EXPECT_NEAR(strain_energy_error(growing), 0.45, 1e-12);
}

TEST(EnergyError, NothingIsMissingOfNothing) {
  const std::vector<EnergyValue> none = {{10, 0.0}, {20, 0.0}, {30, 0.0}};
  EXPECT_EQ(strain_energy_error(none), 0.0);
}

}  // namespace
}  // namespace clevis::stress
