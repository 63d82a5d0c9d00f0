// What an integration tells while it runs.
#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "mechanism/simulate.h"
#include "support/planar_definition.h"
#include "support/planar_linkages.h"

namespace clevis::mechanism {
namespace {

TEST(Progress, RisesToTheEndOverAllPasses) {
  for (const bool at_peaks : {false, true}) {
    std::vector<double> told;
    SimulationSettings settings{.duration = 0.03};
    settings.at_peaks = at_peaks;
    settings.progress = [&](double share) {
      told.push_back(share);
    };
    simulate(testing::definition_of(testing::andrews()), settings);
    ASSERT_GT(told.size(), 4u) << at_peaks;
    EXPECT_TRUE(std::ranges::is_sorted(told)) << at_peaks;
    EXPECT_GE(told.front(), 0.0);
    EXPECT_LT(told.front(), 0.5);
    EXPECT_GT(told.back(), 0.8);
    EXPECT_LE(told.back(), 1.0);
  }
}

}  // namespace
}  // namespace clevis::mechanism
