#include "assessment/buckling/part_holds.h"

#include <algorithm>
#include <initializer_list>

#include <gtest/gtest.h>

namespace clevis::assessment {
namespace {

using Groups = std::vector<loads::HoldingGroups>;

constexpr int kRows = 12;  // of two seats, force and moment each

/// A link along x between joints at bore_A and bore_B.
/// @param held  unit wrenches that joints hold, at rows of both seats.
LoadSet link(std::initializer_list<int> held, const char* first = "bore_A",
             const char* second = "bore_B") {
  Eigen::MatrixXd columns =
      Eigen::MatrixXd::Zero(kRows, static_cast<int>(held.size()));
  int column = 0;
  for (const int row : held) columns(row, column++) = 1.0;
  LoadSet set;
  set.history.seats = {{.name = "A", .group = first},
                       {.name = "B", .group = second, .p_LS = {0.2, 0.0, 0.0}}};
  set.history.hold = [columns](double) {
    return loads::SeatHold{.held = columns};
  };
  set.history.instants.resize(1);
  return set;
}

Groups groups_of(const LoadSet& set) {
  Groups groups;
  for (const auto& hold : part_holds(set, set.history)) {
    groups.push_back(hold.groups);
  }
  return groups;
}

// Hinges across the line: which of them has the play about it is not known.
TEST(PartHolds, RollThatBothEndsHoldCountsAtEither) {
  EXPECT_EQ(groups_of(link({0, 1, 2, 3, 4, 6, 7, 8, 9, 10})),
            (Groups{{"bore_A", "bore_B"}, {"bore_B", "bore_A"}}));
}

TEST(PartHolds, RollThatOneEndHoldsCountsThere) {
  EXPECT_EQ(groups_of(link({0, 1, 2, 3, 6, 7, 8})),
            (Groups{{"bore_A", "bore_B"}}));
  EXPECT_EQ(groups_of(link({0, 1, 2, 6, 7, 8, 9})),
            (Groups{{"bore_B", "bore_A"}}));
}

// Scenes name their pins in any order.
TEST(PartHolds, OrderOfTheSeatsDecidesNothing) {
  EXPECT_EQ(
      groups_of(link({0, 1, 2, 3, 4, 6, 7, 8, 9, 10}, "bore_B", "bore_A")),
      groups_of(link({0, 1, 2, 3, 4, 6, 7, 8, 9, 10})));
}

}  // namespace
}  // namespace clevis::assessment
