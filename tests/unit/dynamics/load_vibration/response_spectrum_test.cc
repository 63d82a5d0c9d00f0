// Shock response spectra of loads with closed forms, and when these begin to
// excite. Source: docs/theory.md, "Vibration under a load history".

#include "dynamics/load_vibration/response_spectrum.h"

#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace clevis::dynamics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kPi = std::numbers::pi, kLeast = 1.02;

LoadPath path_of(const std::vector<std::pair<double, double>>& knots) {
  const auto n = static_cast<Index>(knots.size());
  VectorXd time(n);
  MatrixXd values(1, n);
  for (Index i = 0; i < n; ++i) {
    std::tie(time[i], values(0, i)) = knots[static_cast<std::size_t>(i)];
  }
  return {time, values, 1e-9};
}

ResponseSpectrum spectrum(const LoadPath& path, double period,
                          double damping = 0.0) {
  return response_spectrum(path, VectorXd::Constant(1, period), damping,
                           kLeast);
}

TEST(ResponseSpectrum, StepsAreAnsweredTwice) {
  const auto found = spectrum(
      path_of({{0, 0}, {5, 0}, {5, 1}, {50, 1}, {50, 1.01}, {90, 1.01}}), 1.0);
  EXPECT_NEAR(found.amplification, 2.0 / 1.01, 0.02);
  ASSERT_EQ(found.onsets.size(), 1U);  // the second adds a hundredth
  EXPECT_EQ(found.onsets[0], 5.0);
  EXPECT_EQ(found.period, 1.0);
  EXPECT_NEAR(found.time, 5.5, 0.1);  // not a later swing as high

  const double zeta = 0.1;
  const double overshoot = std::exp(-zeta * kPi / std::sqrt(1.0 - zeta * zeta));
  EXPECT_NEAR(spectrum(path_of({{0, 0}, {5, 0}, {5, 1}, {50, 1}}), 1.0, zeta)
                  .amplification,
              1.0 + overshoot, 0.01);
}

// 1 + |sin(π r)|/(π r) after a ramp of r periods.
TEST(ResponseSpectrum, Ramps) {
  for (const double r : {0.1, 0.5, 1.5, 2.5}) {
    const auto found = spectrum(
        path_of({{0, 0}, {3, 0}, {3, 0}, {3 + r, 1}, {3 + r, 1}, {9 + r, 1}}),
        1.0);
    EXPECT_NEAR(found.amplification,
                1.0 + std::abs(std::sin(kPi * r)) / (kPi * r), 0.01)
        << r;
  }
}

/// Even instants, 48 in each period.
LoadPath cycles(double count, double period, double (*shape)(double turn)) {
  std::vector<std::pair<double, double>> knots{{0, 0}};
  for (int i = 0; i <= static_cast<int>(48 * count); ++i) {
    knots.emplace_back(7.0 + period * i / 48, shape(2.0 * kPi * i / 48));
  }
  return path_of(knots);
}

// A sine at the oscillator's frequency has it swing by π more each cycle.
TEST(ResponseSpectrum, ResonanceGrows) {
  const auto found = spectrum(cycles(12, 1.0,
                                     [](double turn) {
                                       return std::sin(turn);
                                     }),
                              1.0);
  EXPECT_NEAR(found.amplification, 12.0 * kPi, 0.05 * kPi);
  ASSERT_GE(found.onsets.size(), 2U);
  EXPECT_GT(found.onsets.front(), 7.0 + 0.25 * 12.0);
  EXPECT_GT(found.onsets.back(), 7.0 + 0.9 * 12.0);
}

TEST(ResponseSpectrum, SlowLoadsAreFollowed) {
  const auto found = spectrum(cycles(12, 20.0,
                                     [](double turn) {
                                       return 1.0 - std::cos(turn);
                                     }),
                              1.0);
  EXPECT_NEAR(found.amplification, 1.0, 0.01);
  EXPECT_TRUE(found.onsets.empty());
}

TEST(ResponseSpectrum, PulseIsOverBeforeItGivesWay) {
  const auto found = spectrum(
      path_of({{0, 0}, {1, 0}, {1.005, 1}, {1.01, 0}, {1.01, 0}, {9, 0}}), 1.0);
  EXPECT_EQ(found.amplification, 1.0);
  EXPECT_TRUE(found.onsets.empty());
}

TEST(ResponseSpectrum, EachCoordinateByItself) {
  VectorXd time(4);
  time << 0, 5, 5, 9;
  MatrixXd values(2, 4);
  values << 1000, 1000, 1000, 1000, 0, 0, 1, 1;
  const auto found = spectrum({time, values, 1e-9}, 1.0);
  EXPECT_NEAR(found.amplification, 2.0, 0.02);
}

/// Even instants, and the period of an oscillator at each.
struct Sweep {
  LoadPath path;
  VectorXd periods;
};
Sweep sweep(double duration, double step, double (*load)(double t),
            double (*period)(double t)) {
  std::vector<std::pair<double, double>> knots{{0, 0}};
  VectorXd periods(static_cast<Index>(duration / step) + 2);
  periods[0] = period(0.0);
  for (Index i = 1; i < periods.size(); ++i) {
    const double t = step * static_cast<double>(i - 1);
    knots.emplace_back(t == 0.0 ? 1e-12 : t, load(t));
    periods[i] = period(t);
  }
  return {path_of(knots), periods};
}

TEST(SweptAmplification, OfOnePeriodIsThatOfItsSpectrum) {
  const LoadPath path = cycles(12, 1.0, [](double turn) {
    return std::sin(turn);
  });
  EXPECT_EQ(
      swept_amplification(path, VectorXd::Constant(path.size(), 1.03), 0.01),
      spectrum(path, 1.03, 0.01).amplification);
}

// A swing's energy goes as its frequency where that changes slowly: of a fourth
// of the frequency twice the swing.
TEST(SweptAmplification, SwingsGrowAsTheFrequencyFalls) {
  const auto [path, periods] = sweep(
      120.0, 0.1,
      [](double) {
        return 1.0;
      },
      [](double t) {
        return 1.0 + 3.0 * std::min(1.0, t / 100.0);
      });
  EXPECT_NEAR(swept_amplification(path, periods, 0.0), 1.0 + 2.0, 0.06);
}

// Through the frequency of a sine, at a rate r [1/s^2]: the largest of
// Fresnel's integral, 1.17 of its end, (ω/2) √(2 π/r).
TEST(SweptAmplification, PassesAResonance) {
  const auto [path, periods] = sweep(
      100.0, 0.02,
      [](double t) {
        return std::sin(2.0 * kPi * t);
      },
      [](double t) {
        return 1.0 / (0.7 + 0.6 * t / 100.0);
      });
  const double rate = 2.0 * kPi * 0.6 / 100.0;
  const double passed = 1.17 * kPi * std::sqrt(2.0 * kPi / rate);
  EXPECT_NEAR(swept_amplification(path, periods, 0.0), passed, 0.05 * passed);
}

}  // namespace
}  // namespace clevis::dynamics
