#include "assessment/judge/time_sampling_error.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

namespace clevis::assessment {
namespace {

loads::LoadHistory at(const std::vector<double>& times) {
  loads::LoadHistory history;
  history.instants.resize(times.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    history.instants[i].time = times[i];
  }
  return history;
}

Eigen::VectorXd values(const std::vector<double>& times,
                       const std::function<double(double)>& f) {
  Eigen::VectorXd v(static_cast<Eigen::Index>(times.size()));
  for (std::size_t i = 0; i < times.size(); ++i) {
    v[static_cast<Eigen::Index>(i)] = f(times[i]);
  }
  return v;
}

std::vector<double> uniform(int n) {
  std::vector<double> times;
  for (int i = 0; i < n; ++i) times.push_back(i / (n - 1.0));
  return times;
}

// 2 + t until it drops to 1: nothing is higher than the 2.6 before the jump.
double drop(double t) {
  return t <= 0.6 ? 2.0 + t : 1.0;
}

TEST(TimeSamplingError, AJumpWithBothSidesIsNone) {
  std::vector<double> times = uniform(40);
  times.push_back(0.6);
  times.push_back(0.6 + 4e-9);
  std::ranges::sort(times);
  // the rise of the slope, a third of its last step, is left
  EXPECT_LT(time_sampling_error(at(times), values(times, drop)), 0.01);
}

TEST(TimeSamplingError, OfLinearRowsIsNone) {
  const std::vector<double> times{0.0, 1.0, 2.0};
  const Eigen::VectorXd peak = Eigen::Vector3d(0.0, 40.0, 40.0);
  loads::LoadHistory history = at(times);
  history.rows = part::BetweenRows::kUnknown;
  EXPECT_EQ(time_sampling_error(history, peak), 40.0);
  history.rows = part::BetweenRows::kLinear;
  EXPECT_EQ(time_sampling_error(history, peak), 0.0);
}

// The way between two rows on which loads are followed is judged by itself.
TEST(TimeSamplingError, OfTheWayBetweenRows) {
  const auto f = [](double t) {
    return 1.0 - (t - 0.46) * (t - 0.46);
  };
  std::vector<double> times{-1.0};
  for (int i = 0; i <= 12; ++i) times.push_back(i / 12.0);
  Eigen::VectorXd peak = values(times, f);
  loads::LoadHistory history = at(times);
  history.rows = part::BetweenRows::kLinear;
  for (std::size_t i = 2; i < 13; ++i) {
    history.instants[i].is_between_rows = true;
  }
  const double doubt = time_sampling_error(history, peak);
  EXPECT_GT(doubt, 0.0);
  EXPECT_GE(peak.maxCoeff() + doubt, 1.0 - 1e-12);
  EXPECT_LT(peak.maxCoeff() + doubt, 1.002);
  // Where nothing is said of the loads there, the rows tell what they may do.
  history.rows = part::BetweenRows::kUnknown;
  EXPECT_NEAR(time_sampling_error(history, peak), doubt + f(0.0) - f(-1.0),
              1e-12);
}

TEST(TimeSamplingError, AJumpBetweenInstantsIs) {
  const std::vector<double> times = uniform(40);
  EXPECT_GT(time_sampling_error(at(times), values(times,
                                                  [](double t) {
                                                    return t <= 0.6 ? 1.0
                                                                    : 2.0 - t;
                                                  })),
            0.005);
}

// A peak of 3 stands behind the jump, seen by instants 0.02 apart: they may
// miss its rounding.
TEST(TimeSamplingError, APieceBehindAJumpIsJudged) {
  std::vector<double> times = uniform(40);
  times.push_back(0.5);
  times.push_back(0.5 + 4e-9);
  std::ranges::sort(times);
  const auto f = [](double t) {
    return t <= 0.5 ? 1.0 : 3.0 - 100.0 * (t - 0.71) * (t - 0.71);
  };
  const Eigen::VectorXd peak = values(times, f);
  const double doubt = time_sampling_error(at(times), peak);
  EXPECT_GE(peak.maxCoeff() + doubt, 3.0 - 1e-12);
  EXPECT_LT(peak.maxCoeff() + doubt, 3.05);
}

// Pieces of few instants: a third of the fall beside the highest one.
TEST(TimeSamplingError, OfAShortPiece) {
  const std::vector<double> times{0.0, 0.2, 0.4,        0.4 + 1e-9, 0.5,
                                  0.6, 0.7, 0.7 + 1e-9, 1.0};
  Eigen::VectorXd peak(9);
  peak << 1.0, 1.0, 1.0, 2.9, 3.0, 2.94, 2.8, 0.5, 0.5;
  EXPECT_NEAR(time_sampling_error(at(times), peak), 0.1 / 3.0, 1e-12);
}

TEST(TimeSamplingError, CasesBehindTheMotionHaveNone) {
  std::vector<double> times = uniform(40);
  times.push_back(0.0);
  const Eigen::VectorXd flat = Eigen::VectorXd::Constant(40, 1.0);
  Eigen::VectorXd peak(41);
  peak << flat, 7.0;
  EXPECT_EQ(time_sampling_error(at(times), peak), 0.0);
}

// Where the loads between instants are known to lie on lines nothing else is in
// doubt, however the peaks jump about; cases behind the motion have none.
TEST(TimeSamplingError, OfASearchedMotionIsWhatItLeft) {
  const std::vector<double> times{0.0, 0.1, 0.1005, 0.101, 0.5, 1.0, 0.0};
  Eigen::VectorXd peak(7);
  peak << 1.0, 1.0, 80.0, 1.0, 2.0, 1.0, 500.0;
  loads::LoadHistory history = at(times);
  EXPECT_GT(time_sampling_error(history, peak), 10.0);
  history.unseen = 1e-3;
  EXPECT_NEAR(time_sampling_error(history, peak), 0.08, 1e-12);
}

}  // namespace
}  // namespace clevis::assessment
