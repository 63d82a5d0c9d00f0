#include "loads/holds/holding_groups.h"

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

namespace clevis::loads {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;

constexpr double kLength = 0.2;  // from bore_A to bore_B along x [m]

/// A lever: joint A and its drive on one bore, joint B or a force on the other.
/// @param held  columns of 18 rows: A, drive A, B.
LoadHistory lever(const MatrixXd& held) {
  LoadHistory history;
  history.seats = {
      {.name = "A", .group = "bore_A"},
      {.name = "drive A", .group = "bore_A"},
      {.name = "B", .group = "bore_B", .p_LS = kLength * Vector3d::UnitX()}};
  history.hold = [held](double) {
    return SeatHold{.held = held};
  };
  return history;
}

/// Unit wrenches at rows.
MatrixXd unit(std::initializer_list<int> rows) {
  MatrixXd columns = MatrixXd::Zero(18, static_cast<int>(rows.size()));
  int column = 0;
  for (const int row : rows) columns(row, column++) = 1.0;
  return columns;
}

using Groups = std::vector<HoldingGroups>;

TEST(HoldingGroups, TwoPinsHoldAcrossTheirLine) {
  // A ball at either end: 3 + 3, one of them along the line once too often.
  EXPECT_EQ(holding_groups(lever(unit({0, 1, 2, 12, 13, 14}))),
            (Groups{{"bore_A", "bore_B"}}));
}

TEST(HoldingGroups, ADrivenPinHoldsALeverAlone) {
  const MatrixXd pin_and_drive = unit({0, 1, 2, 3, 4, 11});
  EXPECT_EQ(holding_groups(lever(pin_and_drive)), (Groups{{"bore_A"}}));
  // B guided along the line only, or across in one direction of two.
  MatrixXd more(18, 7);
  more << pin_and_drive, unit({12});
  EXPECT_EQ(holding_groups(lever(more)), (Groups{{"bore_A"}}));
  more.col(6) = unit({13});
  EXPECT_EQ(holding_groups(lever(more)), (Groups{{"bore_A"}}));
}

// A link of a mechanism that is free to move: B holds across the plane alone.
TEST(HoldingGroups, ALinkThatMayTurnIsHeldByItsPins) {
  EXPECT_EQ(holding_groups(lever(unit({0, 1, 2, 3, 4, 14}))),
            (Groups{{"bore_A", "bore_B"}}));
  EXPECT_EQ(holding_groups(lever(unit({0, 1, 2, 3, 4}))), (Groups{{"bore_A"}}));
}

// A disc's bore and rim have one middle, but for round-off.
TEST(HoldingGroups, SeatsOneRoundOffApartAreHeldAsAtOnePlace) {
  LoadHistory history = lever(unit({0, 1, 2, 3, 4, 11}));
  for (const double apart : {0.0, 1e-18, 0.05}) {
    history.seats[2].p_LS = apart * Vector3d::UnitX();
    EXPECT_EQ(holding_groups(history), (Groups{{"bore_A"}})) << apart;
  }
}

// What joints hold comes first; of force elements those that yield.
TEST(ReferenceGroups, OfAPartOnForceElementsAreTheirSeats) {
  LoadHistory history = lever(unit({0, 1, 2, 3, 4, 11}));
  history.seats[2].name = "force spring";
  EXPECT_EQ(reference_groups(history), (HoldingGroups{"bore_A"}));
  const auto spring_on = [&](std::initializer_list<int> rows) {
    history.hold = [sprung = unit(rows)](double) {
      return SeatHold{.held = MatrixXd(18, 0), .sprung = 1e3 * sprung};
    };
  };
  spring_on({13});
  EXPECT_EQ(reference_groups(history), (HoldingGroups{"bore_B"}));
  spring_on({0, 13});
  EXPECT_EQ(reference_groups(history), (HoldingGroups{"bore_A", "bore_B"}));
  spring_on({});
  EXPECT_EQ(reference_groups(history), holding_groups(history).front());
}

// A hinge leaves the turn to a spring; held by a drive, it has no say.
TEST(ReferenceGroups, ForceElementsHoldWhatJointsLeave) {
  LoadHistory history = lever(MatrixXd(18, 0));
  history.seats[2].name = "force spring";
  const auto reference = [&](std::initializer_list<int> held,
                             double stiffness) {
    history.hold = [held = unit(held), stiffness](double) {
      return SeatHold{.held = held,
                      .sprung = std::sqrt(stiffness) * unit({13})};
    };
    return reference_at(history, reference_groups(history), 0.0);
  };
  EXPECT_TRUE(reference({0, 1, 2, 3, 4, 11}, 1e6).sprung.empty());
  const PartHold sprung = reference({0, 1, 2, 3, 4}, 1e6);
  ASSERT_FALSE(sprung.sprung.empty());
  double squares = 0.0;
  for (const GroupHold& hold : sprung.sprung) {
    squares += hold.wrenches.squaredNorm();
  }
  EXPECT_DOUBLE_EQ(squares, 1e6);
  EXPECT_TRUE(are_alike(sprung, reference({0, 1, 2, 3, 4}, 1e6)));
  EXPECT_FALSE(are_alike(sprung, reference({0, 1, 2, 3, 4}, 2e6)));
  // One at a joint holds the mechanism.
  history.seats[2].name = "B";
  EXPECT_TRUE(reference({0, 1, 2, 3, 4}, 1e6).sprung.empty());
}

// The drive's face may be another than the pin's bore.
TEST(HoldingGroups, ADriveOnAnotherFaceHoldsTheTurn) {
  LoadHistory history = lever(unit({0, 1, 2, 3, 4, 11, 14}));
  history.seats[1].group = "hub";
  EXPECT_EQ(holding_groups(history), (Groups{{"bore_A"}}));
}

// A guide on bore_A, and what holds along it; across it B would bend the part.
TEST(HoldingGroups, AGuideWhoseDriveHoldsAlongItHoldsAlone) {
  const MatrixXd guide = unit({1, 2, 3, 4, 5});
  MatrixXd all(18, 6);
  all << guide, unit({12});
  EXPECT_EQ(holding_groups(lever(all)), (Groups{{"bore_A"}}));
  MatrixXd across(18, 5);
  across << unit({2, 3, 4, 5}), unit({13});
  EXPECT_EQ(holding_groups(lever(across)), (Groups{{"bore_A", "bore_B"}}));
}

TEST(HoldingGroups, WhatNothingHoldsHasNone) {
  EXPECT_EQ(holding_groups(lever(MatrixXd(18, 0))), (Groups{{}}));
  // A moment alone holds no place.
  EXPECT_EQ(holding_groups(lever(unit({11}))), (Groups{{}}));
}

// What two bodies hold between them counts at both seats.
TEST(HoldingGroups, PartlyHeldAtBothSeats) {
  EXPECT_EQ(holding_groups(lever(unit({1, 13}))),
            (Groups{{"bore_A", "bore_B"}}));
}

// A ball on A, a rod across at B in both directions, and the roll.
TEST(HoldAt, TheRollIsHeldWhereItsJointHoldsIt) {
  const HoldingGroups groups = {"bore_A", "bore_B"};
  const auto at_first = hold_at(lever(unit({0, 1, 2, 13, 14, 3})), groups, 0.0);
  EXPECT_EQ(at_first.groups, groups);
  EXPECT_TRUE(at_first.held.empty());
  const auto at_second =
      hold_at(lever(unit({0, 1, 2, 13, 14, 15})), groups, 0.0);
  EXPECT_EQ(at_second.groups, (HoldingGroups{"bore_B", "bore_A"}));
  EXPECT_TRUE(at_second.held.empty());
}

// A rod off the axis holds across and the roll in one.
TEST(HoldAt, MixedConditionsHoldInPlaceOfGroups) {
  MatrixXd held(18, 6);
  held << unit({0, 1, 2, 14, 3}), unit({13}) + 0.01 * unit({15});
  const auto found = hold_at(lever(held), {"bore_A", "bore_B"}, 0.0);
  EXPECT_EQ(found.held.size(), 2U);
  EXPECT_FALSE(is_redundant(found.held));
}

// What is held along the line bends nothing: a link at B that stands oblique.
TEST(HoldAt, AnObliqueLinkHoldsAcross) {
  MatrixXd held(18, 6);
  held << unit({0, 1, 2, 14, 3}), unit({13}) + unit({12});
  EXPECT_TRUE(hold_at(lever(held), {"bore_A", "bore_B"}, 0.0).held.empty());
}

TEST(HoldAt, RedundantIsWhatBalanceDoesNotNeed) {
  const auto redundant = [](const MatrixXd& held) {
    return is_redundant(held_groups(lever(held), 0.0));
  };
  EXPECT_FALSE(redundant(unit({0, 1, 2, 13, 14, 15})));
  EXPECT_TRUE(redundant(unit({0, 1, 2, 12, 13, 14})));  // two balls
  EXPECT_TRUE(redundant(unit({0, 1, 2, 3, 4, 5, 13})));
}

// Names, not the order of a scene's tables, say which comes first.
TEST(HoldingGroups, ComeInTheOrderOfTheirNames) {
  LoadHistory history = lever(unit({0, 1, 2, 12, 13, 14}));
  for (Seat& seat : history.seats) {
    seat.group = seat.group == "bore_A" ? "right" : "left";
  }
  EXPECT_EQ(holding_groups(history), (Groups{{"left", "right"}}));
}

TEST(HoldingGroups, OfCasesEachTwoBearingSeats) {
  LoadHistory history;
  history.seats = {{.name = "1", .group = "a", .kind = SeatKind::kBearing},
                   {.name = "2", .group = "b", .kind = SeatKind::kBearing},
                   {.name = "3", .group = "face", .kind = SeatKind::kTraction},
                   {.name = "4", .group = "c", .kind = SeatKind::kBearing},
                   {.name = "5", .group = "a", .kind = SeatKind::kBearing}};
  EXPECT_EQ(holding_groups(history),
            (Groups{{"a", "b"}, {"a", "c"}, {"b", "c"}}));
}

/// A ball at A, and on B a slide whose wall has its middle at B's point: a
/// guide touches it so far behind that, and turns about a pin so far.
LoadHistory in_a_guide(double touched, double pin) {
  MatrixXd held = unit({0, 1, 2, 3, 13, 14});
  held(17, 4) = pin;   // y at an arm along x
  held(16, 5) = -pin;  // z
  LoadHistory history = lever(held);
  history.seats[2].slide = SlideWall{};
  history.hold = [held, touched](double) {
    SeatHold hold{.held = held};
    hold.zones.resize(3);
    hold.zones[2].low[0] = touched - 0.005;
    hold.zones[2].high[0] = touched + 0.005;
    return hold;
  };
  return history;
}

// Its mean motion is that of what is touched: the wall's middle is no place.
TEST(HoldAt, ASlideHoldsByItselfWhereItTouches) {
  const HoldingGroups groups{"bore_A", "bore_B"};
  EXPECT_TRUE(hold_at(in_a_guide(0.0, 0.0), groups, 0.0).held.empty());
  EXPECT_TRUE(hold_at(in_a_guide(0.05, 0.05), groups, 0.0).held.empty());
  EXPECT_FALSE(hold_at(in_a_guide(0.05, 0.0), groups, 0.0).held.empty());
  EXPECT_FALSE(hold_at(in_a_guide(0.0, 0.05), groups, 0.0).held.empty());
  // A wall with its middle at the ball, of which other places are touched.
  LoadHistory about_the_ball = in_a_guide(0.05, 0.05);
  about_the_ball.seats[2].p_LS.setZero();
  EXPECT_EQ(holding_groups(about_the_ball), Groups{groups});
}

}  // namespace
}  // namespace clevis::loads
