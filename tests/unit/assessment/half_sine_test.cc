#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "assessment/vibration/duration_ratio.h"

namespace clevis::assessment {
namespace {

/// y'' + (2π)² y = (2π)² sin(π t/r) up to r, then free; by small steps of
/// Störmer's rule.
double by_steps(double r) {
  const double w2 = std::pow(2.0 * std::numbers::pi, 2), h = 1e-4;
  const auto push = [&](double t) {
    return t < r ? w2 * std::sin(std::numbers::pi * t / r) : 0.0;
  };
  double y = 0.0, v = 0.0, largest = 0.0;
  for (double t = 0.0; t < r + 1.0; t += h) {
    v += 0.5 * h * (push(t) - w2 * y);
    y += h * v;
    v += 0.5 * h * (push(t + h) - w2 * y);
    largest = std::max(largest, std::abs(y));
  }
  return largest;
}

TEST(HalfSine, AmplificationOfAMode) {
  for (const double r : {0.05, 0.25, 0.5, 0.81, 1.0, 1.7, 3.0, 6.0, 20.0}) {
    EXPECT_NEAR(half_sine_amplification(r), by_steps(r), 1e-5) << r;
  }
}

TEST(HalfSine, LargestNearFourFifthsOfAPeriod) {
  EXPECT_NEAR(half_sine_amplification(0.81), 1.77, 0.005);
  EXPECT_NEAR(half_sine_amplification(1e3), 1.0, 1e-3);
  // an impulse: ω ∫ = 2π · 2r/π
  EXPECT_NEAR(half_sine_amplification(1e-3), 4e-3, 1e-5);
}

// A force that rises evenly in t and stays: 1 + |sin(π t)|/(π t) at most.
TEST(HalfSine, QuickRiseIsAStep) {
  EXPECT_NEAR(pulse_amplification(10.0, 0.001), 2.0, 1e-12);
  EXPECT_NEAR(pulse_amplification(10.0, 2.5), 1.0 + 1.0 / (M_PI * 2.5), 1e-12);
  EXPECT_EQ(pulse_amplification(3.0, 1.5), half_sine_amplification(3.0));
  EXPECT_EQ(pulse_amplification(0.2, 0.001), half_sine_amplification(0.2));
}

}  // namespace
}  // namespace clevis::assessment
