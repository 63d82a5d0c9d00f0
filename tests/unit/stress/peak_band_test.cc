#include "stress/peaks/peak_band.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "stress/field/stress_history.h"

namespace clevis::stress {
namespace {

std::vector<SequenceValue> from_degree_two(const std::vector<double>& values) {
  std::vector<SequenceValue> sequence;
  for (std::size_t k = 0; k < values.size(); ++k) {
    sequence.push_back({static_cast<int>(k) + 2, values[k]});
  }
  return sequence;
}

TEST(PeakBand, ContainsTheLimitOfGeometricConvergence) {
  for (const double q : {0.05, 0.2, 0.35, 0.5, 0.7}) {
    for (const double first : {-30.0, 20.0}) {
      const auto sequence =
          from_degree_two({100 + first, 100 + first * q, 100 + first * q * q});
      const Band band = peak_band(sequence, 0.01);
      EXPECT_LE(band.low, 100.0 + 1e-9) << q << " " << first;
      EXPECT_GE(band.high, 100.0 - 1e-9) << q << " " << first;
      EXPECT_EQ(band.value, sequence.back().value);
    }
  }
}

TEST(PeakBand, ContainsTheLimitOfAnAlternatingSequence) {
  for (const double q : {0.1, 0.4, 0.7}) {
    const auto band = peak_band(
        from_degree_two({100 + 8.0, 100 - 8.0 * q, 100 + 8.0 * q * q}), 0.01);
    EXPECT_LE(band.low, 100.0);
    EXPECT_GE(band.high, 100.0);
    EXPECT_NE(band.verdict, Convergence::kSingular);
  }
}

// Peaks at a corner grow like p^(2 − 2λ): 270° notch, clamped edge (ν = 0.3).
TEST(PeakBand, CornersAreSingular) {
  for (const double lambda : {0.5444837, 0.711173}) {
    std::vector<double> peaks;
    for (int p = 2; p <= 4; ++p) {
      peaks.push_back(50e6 * std::pow(p, 2 - 2 * lambda));
    }
    EXPECT_EQ(peak_band(from_degree_two(peaks), 0.01).verdict,
              Convergence::kSingular)
        << lambda;
  }
}

// A bore's peak by degrees 2 to 5 sinks by 0.15 % twice: slow, but no singular
// stress sinks. Of probes, which have a sign, the size counts.
TEST(PeakBand, WhatSinksIsNotSingular) {
  const std::vector<double> sinks = {27.5063, 27.9457, 27.9018, 27.8605};
  for (const double sign : {1.0, -1.0}) {
    std::vector<double> values, mirrored;
    for (const double value : sinks) {
      values.push_back(sign * value);
      mirrored.push_back(sign * (55.8 - value));
    }
    EXPECT_EQ(peak_band(from_degree_two(values), 0.0047).verdict,
              Convergence::kNotConverged);
    EXPECT_EQ(peak_band(from_degree_two(mirrored), 0.0047).verdict,
              Convergence::kSingular);
  }
}

TEST(PeakBand, VerdictFollowsTheTolerance) {
  const auto sequence = from_degree_two({90.0, 97.0, 100.0});
  EXPECT_EQ(peak_band(sequence, 0.05).verdict, Convergence::kConverged);
  EXPECT_EQ(peak_band(sequence, 0.01).verdict, Convergence::kNotConverged);
}

TEST(PeakBand, NoiseOfRoundOffIsConverged) {
  const auto band =
      peak_band(from_degree_two({100.0, 100.0 + 1e-9, 100.0 - 1e-9}), 0.01);
  EXPECT_EQ(band.verdict, Convergence::kConverged);
  EXPECT_EQ(peak_band(from_degree_two({7.0, 7.0, 7.0}), 1e-6).verdict,
            Convergence::kConverged);
}

TEST(PeakBand, ErraticValuesAreNotConverged) {
  EXPECT_EQ(peak_band(from_degree_two({100.0, 60.0, 110.0}), 0.01).verdict,
            Convergence::kNotConverged);
}

TEST(PeakBand, ZeroStressIsExact) {
  const Band band = peak_band(from_degree_two({0.0, 0.0, 0.0}), 0.01);
  EXPECT_EQ(band.verdict, Convergence::kConverged);
  EXPECT_EQ(band.low, 0.0);
  EXPECT_EQ(band.high, 0.0);
}

TEST(PeakBand, FewerThanThreeValuesSayNothing) {
  EXPECT_EQ(peak_band(from_degree_two({100.0}), 0.01).verdict,
            Convergence::kNotConverged);
  EXPECT_EQ(peak_band(from_degree_two({100.0, 100.0}), 0.01).verdict,
            Convergence::kNotConverged);
}

TEST(LocalBand, HoldsWhatHigherDegreesNearbySayAndTheSolvedValue) {
  const Band band = local_band({95.0, 99.0, 100.1, 100.2}, 0.1);
  EXPECT_EQ(band.value, 99.0);
  EXPECT_EQ(band.low, 99.0);
  EXPECT_NEAR(band.high, 100.2 + 0.65 * 1.2, 1e-12);
  EXPECT_EQ(band.verdict, Convergence::kConverged);
}

TEST(LocalBand, DoubtsWhatTheLastDegreeNearbyStillChanges) {
  const Band band = local_band({99.0, 99.0, 97.0, 100.0}, 0.01);
  EXPECT_NEAR(band.high, 103.0, 1e-12);
  EXPECT_NEAR(band.low, 97.0, 1e-12);
  EXPECT_EQ(band.verdict, Convergence::kNotConverged);
}

TEST(LocalBand, CountsWhatComesFromFarAway) {
  EXPECT_NEAR(local_band({90.0, 100.0, 100.0, 100.0}, 1e-3).high, 100.1, 1e-12);
  EXPECT_NEAR(local_band({100.0, 100.0, 100.0, 100.0, 50.0}, 1e-3).high, 100.5,
              1e-12);
}

// A peak between two instants of a sine is missed by at most its curvature.
TEST(TimeSampling, CoversWhatACoarseMotionMisses) {
  for (const int n : {9, 11, 24, 41}) {
    Eigen::VectorXd peak(n);
    for (int i = 0; i < n; ++i) {
      peak[i] = 10.0 + std::sin(3.0 * i / (n - 1.0) + 0.4);
    }
    const double missed = 11.0 - peak.maxCoeff();
    EXPECT_GE(time_sampling_error(peak), 0.98 * missed) << n;
  }
}

// Flanks of 1/(1 + x²) are steeper than a parabola's: half of its width holds
// two rows, their middle its top.
TEST(TimeSampling, CoversATopOfSteeperFlanks) {
  Eigen::VectorXd peak(16);
  for (int i = 0; i < peak.size(); ++i) {
    const double x = 0.5 * (i - 7.5);
    peak[i] = 1.0 / (1.0 + x * x);
  }
  EXPECT_GE(time_sampling_error(peak), 1.0 - peak.maxCoeff());
}

TEST(TimeSampling, PeakAtAnEndMissesNothing) {
  EXPECT_EQ(time_sampling_error(Eigen::VectorXd::LinSpaced(21, 1.0, 2.0)), 0.0);
  EXPECT_EQ(time_sampling_error(Eigen::VectorXd::Constant(1, 3.0)), 0.0);
}

TEST(TimeSampling, FewInstantsTellNothing) {
  EXPECT_EQ(time_sampling_error(Eigen::Vector3d(1.0, 4.0, 2.0)), 3.0);
  // A peak between two of six instants: the parabola does not see it.
  Eigen::VectorXd six(6);
  six << 7.0, 8.0, 8.2, 8.3, 8.37, 8.1;
  EXPECT_NEAR(time_sampling_error(six), 1.37, 1e-12);
}

// A thin plate under a tilting pin, degrees 2 to 5 [MPa]; 159.7 in truth.
TEST(PeakBand, AnOvershootIsHeldByHalfOfTheChangeBefore) {
  const auto sequence = from_degree_two({141.4, 156.2, 162.4, 162.5});
  EXPECT_GT(peak_band(sequence, 0.01).low, 159.7);
  const Band wide = peak_band(sequence, 0.01, 0.5);
  EXPECT_LT(wide.low, 159.7);
  EXPECT_EQ(wide.verdict, Convergence::kNotConverged);
  EXPECT_NEAR(wide.high - wide.value, 0.5 * (162.4 - 156.2), 1e-9);
}

}  // namespace
}  // namespace clevis::stress
