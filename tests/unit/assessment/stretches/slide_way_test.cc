#include "assessment/stretches/slide_way.h"

#include <vector>

#include <gtest/gtest.h>

namespace clevis::assessment {
namespace {

/// Two pins that slide in walls, by so much of each second [m].
loads::LoadHistory sliding(const std::vector<double>& rates) {
  loads::LoadHistory history;
  for (const char* group : {"wall", "other"}) {
    loads::Seat& seat = history.seats.emplace_back();
    seat.group = group;
    seat.kind = loads::SeatKind::kBearing;
    seat.slide = loads::SlideWall{};
  }
  for (int i = 0; i < 3; ++i) {
    loads::InstantLoad& instant = history.instants.emplace_back();
    instant.time = i;
    for (const double rate : rates) {
      loads::ContactZone& zone = instant.zones.emplace_back();
      zone.low[0] = rate * i - 0.01;
      zone.high[0] = rate * i + 0.01;
    }
  }
  return history;
}

TEST(SlideWay, OfTheSlideThatGoesFarthest) {
  const std::vector<double> places = slide_way(sliding({0.01, -0.05}), 1e-3);
  ASSERT_EQ(places.size(), 3U);
  EXPECT_NEAR(places[2] - places[0], -0.1, 1e-15);
  EXPECT_TRUE(slide_way(sliding({1e-14, 1e-4}), 1e-3).empty());
  loads::LoadHistory fixed = sliding({0.01, -0.05});
  fixed.seats[1].slide.reset();
  EXPECT_NEAR(slide_way(fixed, 1e-3)[2], 0.02, 1e-15);
  fixed.seats[0].slide.reset();
  EXPECT_TRUE(slide_way(fixed, 1e-3).empty());
}

TEST(SlideWay, UnknownPlacesAreThoseBefore) {
  loads::LoadHistory history = sliding({0.01, 0.0});
  history.instants[0].zones[0] = {};
  history.instants[2].zones.clear();
  EXPECT_EQ(slide_way(history, 1e-3), std::vector<double>{});
  history.instants[2] = sliding({0.02, 0.0}).instants[2];
  history.instants[0].zones[0] = {};
  const std::vector<double> places = slide_way(history, 1e-3);
  ASSERT_EQ(places.size(), 3U);
  EXPECT_EQ(places[0], places[1]);
  EXPECT_NEAR(places[2], 0.04, 1e-15);
}

}  // namespace
}  // namespace clevis::assessment
