#include "assessment/vibration/stretch_choice.h"

#include <gtest/gtest.h>

namespace clevis::assessment {
namespace {

LowVibration of_ratio(double ratio, const char* group) {
  LowVibration low;
  low.ratio = ratio;
  low.group = group;
  return low;
}

/// @param ratio, error  by the high degree.
VibrationResult found(double ratio, double error = 0.0) {
  VibrationResult result;
  result.ratio = ratio;
  result.degree_error = error;
  return result;
}

TEST(StretchChoice, OneFarBelowTheLargestIsNotRefined) {
  EXPECT_TRUE(is_far_below(0.49, 2.0));
  EXPECT_FALSE(is_far_below(0.51, 2.0));
  EXPECT_FALSE(is_far_below(0.1, 0.0));  // it is the first
}

TEST(StretchChoice, OneOnTheSameSurfaceGrowsAsTheFirst) {
  const LowVibration first = of_ratio(2.0, "bore_A");
  EXPECT_TRUE(is_covered(of_ratio(1.99, "bore_A"), first, found(2.6)));
  EXPECT_TRUE(is_covered(of_ratio(1.99, "bore_A"), first, found(2.0)));
  // It may grow though the first sinks.
  EXPECT_FALSE(is_covered(of_ratio(1.99, "bore_A"), first, found(1.9)));
  EXPECT_TRUE(is_covered(of_ratio(1.99, "bore_A"), first, found(1.9, 0.06)));
}

TEST(StretchChoice, OneOnAnotherSurfaceMayGrowByATenthMore) {
  const LowVibration first = of_ratio(2.0, "bore_A");
  EXPECT_TRUE(is_covered(of_ratio(1.81, "bore_B"), first, found(2.2)));
  EXPECT_FALSE(is_covered(of_ratio(1.83, "bore_B"), first, found(2.2)));
  EXPECT_TRUE(is_covered(of_ratio(1.83, "bore_A"), first, found(2.2)));
  // Of peaks on no named surface nothing says that they share one.
  EXPECT_FALSE(is_covered(of_ratio(1.83, ""), of_ratio(2.0, ""), found(2.2)));
}

TEST(StretchChoice, ItsOwnErrorsCount) {
  LowVibration low = of_ratio(1.7, "bore_A");
  const LowVibration first = of_ratio(2.0, "bore_A");
  EXPECT_TRUE(is_covered(low, first, found(2.0)));
  low.shape_error = 0.1;
  low.path_error = 0.1;
  EXPECT_FALSE(is_covered(low, first, found(2.0)));
  low.shape_error = 1.0;  // by the fewest shapes
  low.path_error = 0.0;
  low.ratio = 0.49;
  EXPECT_TRUE(is_covered(low, first, found(2.0)));
}

TEST(StretchChoice, NothingIsCoveredByWhatWasNotFound) {
  EXPECT_FALSE(
      is_covered(of_ratio(1.0, "bore_A"), of_ratio(2.0, "bore_A"), {}));
  EXPECT_FALSE(
      is_covered(of_ratio(0.0, "bore_A"), of_ratio(0.0, "bore_A"), found(1.0)));
}

TEST(StretchChoice, TheLargerPeakGoesWithTheLargerDeflection) {
  VibrationResult a = found(2.0, 0.1), b = found(2.1);
  a.deflection = 1e-3;
  b.deflection = 2e-3;
  const VibrationResult larger = larger_of(a, b);
  EXPECT_EQ(larger.ratio, 2.0);
  EXPECT_EQ(larger.deflection, 2e-3);
}

}  // namespace
}  // namespace clevis::assessment
