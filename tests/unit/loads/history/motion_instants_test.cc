#include "loads/history/motion_instants.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace clevis::loads {
namespace {

InstantLoad at(double time, double low) {
  InstantLoad instant;
  instant.time = time;
  ContactZone& zone = instant.zones.emplace_back();
  zone.low[0] = low;
  zone.high[0] = low + 0.02;
  return instant;
}

LoadHistory travelling() {
  LoadHistory history;
  history.seats.emplace_back().slide = SlideWall{};
  history.instants = {at(0.0, -0.05), at(1.0, -0.03), at(2.0, 0.01),
                      at(3.0, 0.05)};
  return history;
}

InstantLoad of_case(double low) {
  InstantLoad instant = at(0.0, low);
  instant.is_case = true;
  return instant;
}

TEST(MotionInstants, CasesStandBehind) {
  LoadHistory history = travelling();
  EXPECT_EQ(motion_length(history), 4U);
  EXPECT_EQ(motion_duration(history), 3.0);
  history.instants.push_back(of_case(0.0));
  EXPECT_EQ(motion_length(history), 4U);
  EXPECT_EQ(motion_duration(history), 3.0);
  EXPECT_EQ(motion_length({}), 0U);
  history.instants = {of_case(0.0), of_case(0.0)};  // cases alone
  EXPECT_EQ(motion_length(history), 1U);
  history.instants = {at(0.0, 0.0), at(1.0, 0.0), at(1.0, 0.0), at(2.0, 0.0)};
  EXPECT_EQ(motion_length(history), 4U);  // a step of a load history
  history.instants = {at(0.0, 0.0), at(0.0, 0.0), at(2.0, 0.0), of_case(0.0)};
  EXPECT_EQ(motion_length(history), 3U);  // a step that begins it
}

TEST(MotionInstants, LongestStepOfASeat) {
  LoadHistory history = travelling();
  EXPECT_NEAR(longest_slide_step(history), 0.4, 1e-12);
  history.instants.push_back(of_case(0.5));
  EXPECT_NEAR(longest_slide_step(history), 0.4, 1e-12);
  history.instants[2].time = 1.0 + 1e-9;  // the other side of an event
  EXPECT_NEAR(longest_slide_step(history), 0.4, 1e-12);
  history.instants[3].zones[0].low[0] = 0.01;  // it stops there
  history.instants[3].zones[0].high[0] = 0.03;
  EXPECT_NEAR(longest_slide_step(history), 1.0 / 3.0, 1e-12);
}

// Of a zone that ends with the wall one end is not known: it is as long as
// another.
TEST(MotionInstants, PlacesOnAWall) {
  LoadHistory history = travelling();
  history.instants[0].zones[0].low[0] = -ContactZone::kAll;
  history.instants[3].zones[0].high[0] = ContactZone::kAll;
  const std::vector<double> places = places_on_wall(history, 0);
  ASSERT_EQ(places.size(), 4U);
  EXPECT_NEAR(places[0], -0.04, 1e-15);
  EXPECT_NEAR(places[2], 0.02, 1e-15);
  EXPECT_NEAR(places[3], 0.06, 1e-15);
  history.instants[1].zones[0] = {};
  EXPECT_TRUE(std::isnan(places_on_wall(history, 0)[1]));
  EXPECT_TRUE(std::isnan(places_on_wall(history, 1)[2]));  // no such zone
}

TEST(MotionInstants, SeatsThatStandHaveNoStep) {
  LoadHistory history = travelling();
  for (std::size_t i = 0; i < 4; ++i) {
    history.instants[i].zones[0].low[0] = 0.03 + 1e-16 * static_cast<double>(i);
    history.instants[i].zones[0].high[0] = 0.05;
  }
  EXPECT_EQ(longest_slide_step(history), 0.0);
  history = travelling();
  for (auto& instant : history.instants) instant.zones[0] = {};
  EXPECT_EQ(longest_slide_step(history), 0.0);  // touched all over
  history = travelling();
  history.seats[0].slide.reset();
  EXPECT_EQ(longest_slide_step(history), 0.0);
}

}  // namespace
}  // namespace clevis::loads
