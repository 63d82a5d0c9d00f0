// Seats of slides taken apart into places of their way.

#include "loads/holds/spread_seats.h"

#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace clevis::loads {
namespace {

using Eigen::MatrixXd;

constexpr double kLeast = 1e-3;

/// Two pins that slide in walls, by so much of each second [m].
LoadHistory sliding(const std::vector<double>& rates, int instants = 9) {
  LoadHistory history;
  for (const char* group : {"wall", "other"}) {
    Seat& seat = history.seats.emplace_back();
    seat.group = group;
    seat.kind = SeatKind::kBearing;
    seat.slide = SlideWall{};
  }
  for (int i = 0; i < instants; ++i) {
    InstantLoad& instant = history.instants.emplace_back();
    instant.time = i;
    for (const double rate : rates) {
      ContactZone& zone = instant.zones.emplace_back();
      zone.low[0] = rate * i - 0.01;
      zone.high[0] = rate * i + 0.01;
    }
  }
  return history;
}

double value_by(const std::vector<PlaceShare>& shares,
                const std::vector<double>& known, int power) {
  double sum = 0.0;
  for (const auto& [place, share] : shares) {
    sum += share * std::pow(known[place], power);
  }
  return sum;
}

TEST(SpreadSeats, CubicSharesAreThoseOfCubics) {
  const std::vector<double> known{-1.0, 0.1, 0.9, 2.2, 3.0, 4.1};
  for (const double place : {-1.0, -0.3, 0.5, 0.9, 2.0, 3.7, 4.1}) {
    const auto shares = cubic_shares_of(place, known);
    EXPECT_EQ(shares.size(), 4U);
    for (int power = 0; power <= 3; ++power) {
      EXPECT_NEAR(value_by(shares, known, power), std::pow(place, power), 1e-12)
          << place;
    }
    // The nearest four: none is farther than any that is left out, but ends.
    if (place > 0.1 && place < 3.0) {
      EXPECT_LT(known[shares[1].first], place + 1e-12);
      EXPECT_GE(known[shares[2].first], place);
    }
  }
  const std::vector<double> two{1.0, 3.0};
  EXPECT_NEAR(value_by(cubic_shares_of(1.5, two), two, 1), 1.5, 1e-15);
}

TEST(SpreadSeats, WhatTravelsIsTakenApart) {
  const LoadHistory history = sliding({0.01, 0.02});
  const SpreadSeats seats(history, 4, kLeast);
  ASSERT_TRUE(seats.travels());
  EXPECT_EQ(seats.seats().size(), 10U);  // five places of each
  ASSERT_EQ(seats.zones().size(), 10U);
  EXPECT_NEAR(seats.zones()[5].low[0], -0.01, 1e-15);
  EXPECT_NEAR(seats.zones()[9].low[0], 0.15, 1e-15);
  // At a place it stands there alone; in between the shares sum to all of it.
  const MatrixXd wrenches = MatrixXd::Identity(12, 12);
  const MatrixXd there = seats.spread(wrenches, 2);
  ASSERT_EQ(there.rows(), 60);
  EXPECT_NEAR((there.middleRows(6, 6) - wrenches.topRows(6)).norm(), 0, 1e-12);
  EXPECT_NEAR(there.topRows(6).norm(), 0.0, 1e-12);
  const MatrixXd between = seats.spread(wrenches, 3);
  MatrixXd sum = MatrixXd::Zero(6, 12);
  for (int place = 0; place < 5; ++place) {
    sum += between.middleRows(6 * place, 6);
  }
  EXPECT_NEAR((sum - wrenches.topRows(6)).norm(), 0.0, 1e-12);
  EXPECT_GT(between.middleRows(6, 6).norm(), 0.5);
  EXPECT_TRUE(seats.stand_alike(3, 3));
  EXPECT_FALSE(seats.stand_alike(3, 4));
}

TEST(SpreadSeats, HoldsAreSpread) {
  const SpreadSeats seats(sliding({0.01, 0.0}), 4, kLeast);
  ASSERT_EQ(seats.seats().size(), 6U);
  SeatHold hold;
  hold.held = MatrixXd::Identity(12, 12);
  hold.weighed = MatrixXd(12, 0);
  hold.spin = MatrixXd::Zero(12, 12);
  hold.spin(0, 7) = 1.0;
  hold.spin(7, 0) = -1.0;
  const SeatHold spread = seats.spread(hold, 4);
  EXPECT_EQ(spread.held.rows(), 36);
  EXPECT_EQ(spread.weighed.rows(), 36);
  EXPECT_EQ(spread.sprung.size(), 0);
  EXPECT_NEAR(spread.spin(12, 31), 1.0, 1e-12);
  EXPECT_NEAR(spread.spin(31, 12), -1.0, 1e-12);
  EXPECT_NEAR(spread.spin.norm(), hold.spin.norm(), 1e-12);
  EXPECT_EQ(spread.zones.size(), 6U);
}

TEST(SpreadSeats, WhatStandsOrIsNoSlideStaysWhole) {
  EXPECT_FALSE(SpreadSeats(sliding({1e-14, 1e-5}), 4, kLeast).travels());
  LoadHistory fixed = sliding({0.01, 0.02});
  fixed.seats[1].slide.reset();
  const SpreadSeats one(fixed, 4, kLeast);
  EXPECT_EQ(one.seats().size(), 6U);
  EXPECT_EQ(one.seats().back().group, "other");
  fixed.seats[0].slide.reset();
  EXPECT_FALSE(SpreadSeats(fixed, 4, kLeast).travels());
}

TEST(SpreadSeats, UnknownPlacesAreThoseBefore) {
  LoadHistory history = sliding({0.01, 0.0});
  history.instants[0].zones[0] = {};
  history.instants[5].zones.clear();
  const SpreadSeats seats(history, 4, kLeast);
  EXPECT_TRUE(seats.stand_alike(0, 1));
  EXPECT_TRUE(seats.stand_alike(5, 4));
  EXPECT_FALSE(seats.stand_alike(5, 6));
}

}  // namespace
}  // namespace clevis::loads
