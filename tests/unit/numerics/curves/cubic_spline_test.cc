#include "numerics/curves/cubic_spline.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace clevis::mechanism {
namespace {

TEST(CubicSpline, ClampedReproducesACubicAtRestAtBothEnds) {
  const auto cubic = [](double t) {
    return 3.0 * t * t - 2.0 * t * t * t;
  };
  const numerics::CubicSpline spline = numerics::interpolating_spline(
      {0.0, 0.2, 0.7, 1.0}, {cubic(0.0), cubic(0.2), cubic(0.7), cubic(1.0)},
      numerics::SplineEnds::kClamped);
  for (double t = 0.0; t <= 1.0; t += 0.05) {
    const numerics::CubicSpline::Point p = spline.at(t);
    EXPECT_NEAR(p.value, cubic(t), 1e-14);
    EXPECT_NEAR(p.rate, 6.0 * t - 6.0 * t * t, 1e-13);
    EXPECT_NEAR(p.acceleration, 6.0 - 12.0 * t, 1e-12);
  }
}

TEST(CubicSpline, NaturalEndsWithoutAcceleration) {
  const numerics::CubicSpline spline = numerics::interpolating_spline(
      {0.0, 1.0, 3.0, 4.0}, {0.0, 2.0, -1.0, 0.5},
      numerics::SplineEnds::kNatural);
  EXPECT_EQ(spline.at(0.0).acceleration, 0.0);
  EXPECT_EQ(spline.at(4.0).acceleration, 0.0);
  for (const double t : {1.0, 3.0}) {  // twice continuously differentiable
    const auto before = spline.at(t - 1e-9), after = spline.at(t + 1e-9);
    EXPECT_NEAR(before.rate, after.rate, 1e-7);
    EXPECT_NEAR(before.acceleration, after.acceleration, 1e-7);
  }
  EXPECT_DOUBLE_EQ(spline.at(1.0).value, 2.0);
  EXPECT_DOUBLE_EQ(spline.at(3.0).value, -1.0);
}

TEST(CubicSpline, RestsOutside) {
  const numerics::CubicSpline spline = numerics::interpolating_spline(
      {1.0, 2.0}, {5.0, 7.0}, numerics::SplineEnds::kClamped);
  EXPECT_EQ(spline.at(0.0).value, 5.0);
  EXPECT_EQ(spline.at(3.0).value, 7.0);
  EXPECT_EQ(spline.at(3.0).rate, 0.0);
  EXPECT_NEAR(spline.at(1.5).value, 6.0, 1e-15);
}

TEST(CubicSpline, FourthOrderOnASine) {
  double last = 0.0;
  for (const int n : {16, 32, 64}) {
    std::vector<double> t, q;
    for (int i = 0; i <= n; ++i) {
      t.push_back(std::numbers::pi * (2.0 * i / n - 0.5));
      q.push_back(std::sin(t.back()));  // at rest at both ends
    }
    const numerics::CubicSpline spline =
        numerics::interpolating_spline(t, q, numerics::SplineEnds::kClamped);
    double error = 0.0;
    for (double s = -1.5; s < 4.7; s += 0.01) {
      error = std::max(error, std::abs(spline.at(s).value - std::sin(s)));
    }
    if (last > 0.0) {
      EXPECT_GT(std::log2(last / error), 3.8);
    }
    last = error;
  }
}

}  // namespace
}  // namespace clevis::mechanism
