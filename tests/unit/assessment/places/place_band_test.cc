#include "assessment/places/place_band.h"

#include <array>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace clevis::assessment {
namespace {

TEST(LargestPlace, AloneKeepsItsBand) {
  const std::array places{PlaceEstimate{90.0, 89.0, 91.0},
                          PlaceEstimate{100.0, 99.0, 101.5}};
  const LargestPlace found = largest_place(places);
  EXPECT_EQ(found.place, 1U);
  EXPECT_DOUBLE_EQ(found.low, 99.0);
  EXPECT_DOUBLE_EQ(found.high, 101.5);
}

TEST(LargestPlace, ReachesLowerAmongEquals) {
  // The third does not reach the largest; mean of the others 99.75.
  const std::array places{PlaceEstimate{99.5, 98.5, 100.5},
                          PlaceEstimate{100.0, 99.0, 101.0},
                          PlaceEstimate{98.0, 97.0, 99.0}};
  const LargestPlace found = largest_place(places);
  EXPECT_EQ(found.place, 1U);
  EXPECT_DOUBLE_EQ(found.low, 98.75);
}

TEST(LargestPlace, EndsWithTheHighestBand) {
  const std::array places{PlaceEstimate{100.0, 99.0, 101.0},
                          PlaceEstimate{99.0, 90.0, 108.0}};
  EXPECT_DOUBLE_EQ(largest_place(places).high, 108.0);
}

// Eight places of one stress with normal errors, bands of two deviations: the
// largest of them is 1.4 deviations too large in the mean, and its own band
// holds the truth far less often than that of one place alone.
TEST(LargestPlace, HoldsAsOftenAsTheBandOfOnePlace) {
  constexpr int kPlaces = 8, kTrials = 4000;
  constexpr double kTruth = 100.0, kReach = 2.0;
  std::mt19937_64 random(16);
  std::normal_distribution<double> error;
  int of_largest = 0, of_its_own = 0, of_one = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<PlaceEstimate> places;
    for (int i = 0; i < kPlaces; ++i) {
      const double value = kTruth + error(random);
      places.push_back({value, value - kReach, value + kReach});
    }
    const LargestPlace found = largest_place(places);
    of_largest += found.low <= kTruth && kTruth <= found.high;
    of_its_own += places[found.place].low <= kTruth;
    of_one += places[0].low <= kTruth && kTruth <= places[0].high;
  }
  EXPECT_GE(of_largest, of_one);
  EXPECT_LT(of_its_own, of_one - kTrials / 20);
}

TEST(ErrorOfJump, CountsFromHalfOfTheStressOn) {
  EXPECT_EQ(error_of_jump(100.0, 50.0), 0.0);
  EXPECT_DOUBLE_EQ(error_of_jump(100.0, 80.0), 15.0);
  EXPECT_DOUBLE_EQ(error_of_jump(100.0, 150.0), 50.0);
}

}  // namespace
}  // namespace clevis::assessment
