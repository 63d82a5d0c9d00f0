#include "report/summary/line_refinement.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace clevis::report {
namespace {

/// A triangular pulse about 0.5, 0.02 wide, over a slow rise.
double pulse(double t) {
  return 0.1 * t + std::max(0.0, 1.0 - std::abs(t - 0.5) / 0.01);
}

std::vector<double> even_times(std::size_t count) {
  std::vector<double> times(count);
  for (std::size_t i = 0; i < count; ++i) {
    times[i] = static_cast<double>(i) / static_cast<double>(count - 1);
  }
  return times;
}

TEST(RefineLines, TakesTheCornersOfAPulse) {
  const auto times = even_times(1001);
  std::vector<double> values;
  for (const double t : times) values.push_back(pulse(t));
  std::set<std::size_t> kept{0, 250, 750, 1000};
  refine_lines(kept, times, values, 1e-6, 100);
  // its foot, top and foot; nothing on the straight rise
  EXPECT_EQ(kept, (std::set<std::size_t>{0, 250, 490, 500, 510, 750, 1000}));
}

TEST(RefineLines, LargestFirstWhereFewAreAllowed) {
  const auto times = even_times(1001);
  std::vector<double> values;
  for (const double t : times) values.push_back(pulse(t));
  std::set<std::size_t> kept{0, 1000};
  refine_lines(kept, times, values, 1e-6, 3);
  EXPECT_EQ(kept, (std::set<std::size_t>{0, 500, 1000}));
}

TEST(RefineLines, AJumpBetweenTwoSamplesOfOneTimeIsKept) {
  const std::vector<double> times{0.0, 1.0, 1.0, 2.0};
  const std::vector<double> values{0.0, 0.0, 5.0, 5.0};
  std::set<std::size_t> kept{0, 3};
  refine_lines(kept, times, values, 0.1, 10);
  EXPECT_EQ(kept, (std::set<std::size_t>{0, 1, 2, 3}));
}

TEST(RefineLines, WithinTheToleranceNothingIsAdded) {
  const auto times = even_times(11);
  std::vector<double> values;
  for (const double t : times) values.push_back(t * t);
  std::set<std::size_t> kept{0, 10};
  refine_lines(kept, times, values, 0.26, 10);
  EXPECT_EQ(kept.size(), 2U);
}

}  // namespace
}  // namespace clevis::report
