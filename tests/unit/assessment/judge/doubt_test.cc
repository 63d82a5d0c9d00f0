#include "assessment/judge/doubt.h"

#include <gtest/gtest.h>

namespace clevis::assessment {
namespace {

constexpr double kTolerance = 0.01;

PeakStress converged() {
  PeakStress peak;
  peak.value = 100e6;
  peak.band_low = 99.7e6;
  peak.band_high = 100.2e6;
  peak.discretization_error = 0.3e6;
  peak.model_error = 0.1e6;
  peak.shares = {.mesh = 0.2e6, .model = 0.1e6};
  peak.verdict = PeakVerdict::kConverged;
  return peak;
}

TEST(Doubt, WidensBothWaysAsTheMeshDoes) {
  PeakStress peak = converged();
  widen_for_cells(peak, 0.5e6, kTolerance);
  EXPECT_DOUBLE_EQ(peak.band_low, 99.2e6);
  EXPECT_DOUBLE_EQ(peak.band_high, 100.7e6);
  EXPECT_DOUBLE_EQ(peak.shares.mesh, 0.7e6);
  EXPECT_DOUBLE_EQ(peak.shares.total(), 0.8e6);
  EXPECT_EQ(peak.verdict, PeakVerdict::kConverged);
}

// 0.3 + 0.1 + 0.7 of 100 MPa are more than a percent.
TEST(Doubt, BeyondTheToleranceNothingHasConverged) {
  PeakStress peak = converged();
  widen_for_cells(peak, 0.7e6, kTolerance);
  EXPECT_EQ(peak.verdict, PeakVerdict::kNotConverged);
  PeakStress singular = converged();
  singular.verdict = PeakVerdict::kSingular;
  widen_for_cells(singular, 0.7e6, kTolerance);
  EXPECT_EQ(singular.verdict, PeakVerdict::kSingular);
}

TEST(Doubt, NoStressIsBelowZero) {
  PeakStress peak = converged();
  widen_for_cells(peak, 200e6, kTolerance);
  EXPECT_EQ(peak.band_low, 0.0);
}

}  // namespace
}  // namespace clevis::assessment
