#include "mechanism/change_points/rank_loss_detector.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace clevis::mechanism {
namespace {

/// All zeros that looks at these times give.
std::vector<double> zeros(const TimedJacobian& jacobian,
                          RankLossDetector& watch,
                          const std::vector<double>& times) {
  std::vector<double> all;
  EXPECT_FALSE(watch.start(jacobian, times.front()));
  for (const double t : times) {
    for (const double zero : watch.look(jacobian, t)) all.push_back(zero);
  }
  for (const double zero : watch.finish()) all.push_back(zero);
  return all;
}

// Rows cos t, sin t and a fixed one: dependent where cos t = 0; by steps of
// half a turn and more.
TEST(RankLossDetector, FindsZerosOfLongSteps) {
  const auto jacobian = [](double t, Eigen::MatrixXd& J) {
    J << std::cos(t), std::sin(t), 0.0, 1.0;
  };
  for (const double step : {0.1, 1.0, 2.0, 3.0}) {
    RankLossDetector watch(2, 2, 2);
    std::vector<double> times;
    for (double t = 0.0; t < 30.0; t += step) times.push_back(t);
    const std::vector<double> found = zeros(jacobian, watch, times);
    ASSERT_GE(found.size(), 8u) << step;
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_NEAR(found[i], (static_cast<double>(i) + 0.5) * std::numbers::pi,
                  1e-12);
    }
  }
}

// There and back within one step: the directions end as they began.
TEST(RankLossDetector, FindsAShortExcursion) {
  const auto jacobian = [](double t, Eigen::MatrixXd& J) {
    J << 1.0, 1.01 - std::sin(t) * 1.02, 1.0, 0.0;
  };
  RankLossDetector watch(2, 2, 2);
  EXPECT_EQ(zeros(jacobian, watch, {0.0, 3.0}).size(), 2u);
}

TEST(RankLossDetector, SaysIfItStartsThere) {
  const auto jacobian = [](double t, Eigen::MatrixXd& J) {
    J << 1.0, t, 1.0, 0.0;
  };
  RankLossDetector watch(2, 2, 2);
  EXPECT_TRUE(watch.start(jacobian, 0.0));
  EXPECT_TRUE(watch.look(jacobian, 1.0).empty());
}

/// Rows that differ by x, which passes zero, and by y.
void put_rows(double x, double y, Eigen::MatrixXd& J) {
  J << 1.0, x, y, 1.0, 0.0, 0.0;
}

/// As beside a branch of x y = 0 along x = t − 1.
TimedJacobian passed_beside(double error) {
  return [error](double t, Eigen::MatrixXd& J) {
    put_rows(t - 1.0, error, J);
  };
}

// However near steps end, and whatever the errors make of directions there.
TEST(RankLossDetector, StepsThatEndBesideAZeroCountItOnce) {
  const double before = 1.0 - 3e-5, behind = 1.0 + 2e-5;
  const std::vector<double> all[] = {{0.0, before, 2.0},
                                     {0.0, behind, 2.0},
                                     {0.0, 1.0, 2.0},
                                     {0.0, before, behind, 2.0},
                                     {0.0, before, 1.0, behind, 2.0},
                                     {0.0, before, 1.0 - 1e-9, 2.0},
                                     {0.0, 0.5, behind}};  // and ends
  for (const auto& times : all) {
    for (const double error : {0.0, 1e-9, 5e-5, -5e-5}) {
      RankLossDetector watch(2, 3, 2);
      const auto found = zeros(passed_beside(error), watch, times);
      ASSERT_EQ(found.size(), 1u) << error << " " << times[1];
      EXPECT_NEAR(found[0], 1.0, 0.5 * std::abs(error) + 1e-12);
    }
  }
}

// Errors that come and go have the sign change three times.
TEST(RankLossDetector, ErrorsNearASingularPositionDoNotMultiplyAZero) {
  const auto jacobian = [](double t, Eigen::MatrixXd& J) {
    const double x = t - 1.0;
    put_rows(x - 4e-5 * std::sin(std::numbers::pi * 5e4 * x), 1e-6, J);
  };
  for (const double end : {1.0 - 1.5e-5, 1.0 + 1e-6, 1.0 + 1.5e-5}) {
    RankLossDetector watch(2, 3, 2);
    const auto found = zeros(jacobian, watch, {0.0, end, 2.0});
    ASSERT_EQ(found.size(), 1u) << end;
    EXPECT_NEAR(found[0], 1.0, 5e-5);
  }
}

// Up to the zero and back, and past it aside: none.
TEST(RankLossDetector, WhatOnlyComesNearIsNoZero) {
  const auto back = [](double t, Eigen::MatrixXd& J) {
    put_rows(1e-6 + (t - 1.0) * (t - 1.0), 0.0, J);
  };
  for (const double end : {0.999, 1.0, 1.001}) {
    RankLossDetector watch(2, 3, 2);
    EXPECT_TRUE(zeros(back, watch, {0.0, end, 2.0}).empty()) << end;
  }
  for (const double end : {0.999, 1.0, 1.001}) {
    RankLossDetector watch(2, 3, 2);
    EXPECT_TRUE(zeros(passed_beside(1e-3), watch, {0.0, end, 2.0}).empty());
  }
}

// The third row stands in for either of the first two where these depend on
// one another, at t = 1; at t = 2 all do.
TEST(RankLossDetector, RowsThatOthersStandInForAreNoLoss) {
  const auto jacobian = [](double t, Eigen::MatrixXd& J) {
    const double all = t - 2.0;
    J << 1.0, 0.0, 1.0, (t - 1.0) * all, 0.3, 0.7 * all;
  };
  for (const double step : {2.5, 0.7, 0.1}) {
    RankLossDetector watch(3, 2, 2);
    std::vector<double> times;
    for (double t = 0.0; t < 4.0; t += step) times.push_back(t);
    const auto found = zeros(jacobian, watch, times);
    ASSERT_EQ(found.size(), 1u) << step;
    EXPECT_NEAR(found[0], 2.0, 1e-12);
  }
}

// Two pairs of rows: zeros of both at once count once, 1e-3 apart twice.
TEST(RankLossDetector, LossesAtOnceAreOne) {
  for (const double apart : {0.0, 1e-7, 1e-3}) {
    const auto jacobian = [apart](double t, Eigen::MatrixXd& J) {
      J.setZero();
      J(0, 0) = J(1, 0) = J(2, 2) = J(3, 2) = 1.0;
      J(1, 1) = t - 1.0;
      J(3, 3) = t - 1.0 - apart;
    };
    for (const double end : {0.5, 1.0 - 1e-5, 1.0 + 1e-5}) {
      RankLossDetector watch(4, 4, 4);
      EXPECT_EQ(zeros(jacobian, watch, {0.0, end, 2.0}).size(),
                apart > 1e-6 ? 2u : 1u)
          << apart << " " << end;
    }
  }
}

// A vector that errors had cross three times has one zero, in the middle.
TEST(NearSingularInterval, MiddleOfSeveralCrossings) {
  NearSingularInterval interval(2);
  interval.enter();
  EXPECT_TRUE(interval.is_open());
  for (const double zero : {1.0, 1.5, 1.6}) interval.note(1, zero);
  EXPECT_EQ(interval.middle_zero(1), 1.5);
  EXPECT_FALSE(interval.middle_zero(0));
  EXPECT_EQ(interval.sign(1), -1.0);
  EXPECT_EQ(interval.sign(0), 1.0);
}

// Steps may end in the interval: it goes on with its signs and zeros. The next
// one begins with none.
TEST(NearSingularInterval, GoesOnUntilItIsLeft) {
  NearSingularInterval interval(1);
  interval.enter();
  interval.note(0, 2.0);
  interval.enter();
  EXPECT_EQ(interval.sign(0), -1.0);
  EXPECT_EQ(interval.zeros().size(), 1u);
  interval.leave();
  EXPECT_FALSE(interval.is_open());
  interval.enter();
  EXPECT_EQ(interval.sign(0), 1.0);
  EXPECT_TRUE(interval.zeros().empty());
}

}  // namespace
}  // namespace clevis::mechanism
