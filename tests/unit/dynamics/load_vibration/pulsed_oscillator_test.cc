#include "dynamics/load_vibration/pulsed_oscillator.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace clevis::dynamics {
namespace {

constexpr double kPi = std::numbers::pi;

/// Of 1 rad/s, under a sine of a frequency over 200 s [rad/s].
double growth(double frequency, double share, double damping) {
  constexpr int kCount = 4001;
  const Eigen::VectorXd time = Eigen::VectorXd::LinSpaced(kCount, 0.0, 200.0);
  const Eigen::MatrixXd values =
      (frequency * time.transpose().array()).sin().matrix();
  return pulsed_growth(LoadPath(time, values, 0.0), 0,
                       {2.0 * kPi, damping, share});
}

// By Mathieu's equation swings grow with share ω / 4, less the damping, where
// the load pulses at twice the frequency.
TEST(PulsedOscillator, GrowsAtTwiceItsFrequency) {
  EXPECT_NEAR(std::log(growth(2.0, 0.1, 0.0)), 0.1 / 4.0 * 200.0, 0.15);
  EXPECT_NEAR(std::log(growth(2.0, 0.2, 0.0)), 0.2 / 4.0 * 200.0, 0.3);
  EXPECT_NEAR(std::log(growth(2.0, 0.2, 0.02)), (0.2 / 4.0 - 0.02) * 200.0,
              0.3);
}

// The first tongue is as wide as half the share to each side.
TEST(PulsedOscillator, StaysBesideIt) {
  EXPECT_LT(growth(2.0 + 0.15, 0.1, 0.0), 1.5);
  EXPECT_LT(growth(2.0, 0.1, 0.03), 1.2);
  EXPECT_LT(growth(0.3, 0.1, 0.0), 1.2);
}

// A share that lasts lowers the frequency: for a speed the place swings
// 1/√(1 − share) as far.
TEST(PulsedOscillator, LastingShareSoftens) {
  const Eigen::VectorXd time = Eigen::VectorXd::LinSpaced(101, 0.0, 50.0);
  const LoadPath path(time, Eigen::MatrixXd::Ones(1, 101), 0.0);
  EXPECT_NEAR(pulsed_growth(path, 0, {2.0 * kPi, 0.0, 0.5}), std::sqrt(2.0),
              0.02);
}

}  // namespace
}  // namespace clevis::dynamics
