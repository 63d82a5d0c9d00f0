#include "assessment/notes/beam_comparison.h"

#include <gtest/gtest.h>

namespace clevis::assessment {
namespace {

TEST(BeamComparison, RatioIsExplainedOnlyOutsideItsRange) {
  PartResult result;
  result.peak.value = 10e6;
  result.peak.group = "bore_C";
  result.beam.peak_stress = 10e6;
  result.beam.governing = "lug net section, bore_C";
  for (const double ratio : {0.8, 1.0, 1.25}) {
    result.beam.ratio_fe_to_beam = ratio;
    EXPECT_EQ(explain_ratio(result.peak, result.beam), "") << ratio;
  }
  for (const double ratio : {0.79, 1.26}) {
    result.beam.ratio_fe_to_beam = ratio;
    EXPECT_NE(explain_ratio(result.peak, result.beam), "") << ratio;
  }
}

}  // namespace
}  // namespace clevis::assessment
