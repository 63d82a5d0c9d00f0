#include "report/parts/buckling_output.h"

#include <gtest/gtest.h>

namespace clevis::report {
namespace {

assessment::PartResult part_that_buckles_at(double low, double factor,
                                            double high) {
  assessment::PartResult part;
  part.buckling.factor = factor;
  part.buckling.band_low = low;
  part.buckling.band_high = high;
  part.buckling.label = "t = 1.5 s";
  part.buckling.model = "3-D, p = 3";
  part.buckling.euler = 1.25;
  return part;
}

TEST(BucklingOutput, LineTellsFactorBandInstantAndEuler) {
  const auto part = part_that_buckles_at(2.25, 2.5, 2.75);
  EXPECT_EQ(buckling_text(part.buckling),
            "buckling 2.5 [2.25, 2.75] times the loads of t = 1.5 s (Euler's "
            "strut 1.25)");
  EXPECT_EQ(buckling_text({}), "");
  assessment::BucklingResult none;
  none.remark = "not computed: no memory";
  EXPECT_EQ(buckling_text(none), "buckling: not computed: no memory");
}

TEST(BucklingOutput, JunitCaseFollowsTheBand) {
  const auto status = [](double low, double factor, double high,
                         const part::Limits& limits) {
    return buckling_case(part_that_buckles_at(low, factor, high), limits)
        .status;
  };
  EXPECT_EQ(status(1.6, 1.7, 1.8, {}), JunitStatus::kPassed);
  EXPECT_EQ(status(1.4, 1.6, 1.8, {}), JunitStatus::kError);
  EXPECT_EQ(status(1.2, 1.3, 1.4, {}), JunitStatus::kFailure);
  EXPECT_EQ(status(1.6, 1.7, 1.8, {.safety_factor = 2.0}),
            JunitStatus::kFailure);
  EXPECT_EQ(status(1.2, 1.3, 1.4, {.safety_factor = 2.0, .buckling = 1.1}),
            JunitStatus::kPassed);
  EXPECT_EQ(buckling_case({}, {}).status, JunitStatus::kSkipped);
}

}  // namespace
}  // namespace clevis::report
