#include "machine/transmissions/module_error.h"

#include <cmath>

#include <gtest/gtest.h>

namespace clevis::machine {
namespace {

TEST(ModuleError, AddsByTheWorstCaseAndByTheRootOfSquares) {
  const ErrorShares shares{1.0, 2.0, 4.0, 3.0};
  const ModuleError error = module_error(shares, -40.0, 0.25);
  EXPECT_EQ(error.compliance, 10.0);
  EXPECT_EQ(error.worst, 17.0);
  EXPECT_NEAR(error.rss, std::sqrt(1.0 + 4.0 + 16.0 + 100.0), 1e-14);
  EXPECT_EQ(error.reversal, 4.0 + 2.0 * 3.0 * 0.25);
}

// J + 2 T_f e from the run, for light and heavy motors, with backlash or
// compliance alone, in any unit.
TEST(ReversalRun, LosesBacklashAndTwiceTheWindUp) {
  const ReversalModel models[] = {
      {0.02, 0.02, 1e-3, 6e-4, 5.0},   {0.3, 0.02, 1e-3, 6e-4, 5.0},
      {0.002, 0.02, 1e-3, 6e-4, 5.0},  {0.02, 0.02, 1e-3, 0.0, 5.0},
      {0.02, 0.02, 1e-3, 6e-4, 0.005}, {80.0, 50.0, 1e-8, 3e-6, 50.0}};
  for (const ReversalModel& m : models) {
    const double formula = m.backlash + 2.0 * m.friction * m.compliance;
    const auto run = run_reversal(m);
    ASSERT_TRUE(run);
    EXPECT_NEAR(*run / formula, 1.0, 1e-6)
        << m.motor_inertia << " " << m.backlash << " " << m.friction;
  }
}

TEST(ReversalRun, MassesTooUnequalAreLeftOut) {
  EXPECT_FALSE(run_reversal({1e-12, 1.0, 1e-3, 1e-4, 1.0}));
}

}  // namespace
}  // namespace clevis::machine
