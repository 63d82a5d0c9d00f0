// A lever or a beam of which a history knows the loads alone: the bore that
// takes a moment about its axis, or the face that takes one, holds it.
#include "loads/parts/clamped_seat.h"

#include <gtest/gtest.h>

#include "loads/holds/holding_groups.h"

namespace clevis::loads {
namespace {

using Eigen::Vector3d;

constexpr double kArm = 0.2, kForce = 100.0;  // [m], [N]

GroupGeometry bore(const char* name, double x) {
  GroupGeometry group;
  group.name = name;
  group.is_cylinder = true;
  group.cylinder = {.p_LC = {x, 0.0, 0.0},
                    .axis_L = Vector3d::UnitZ(),
                    .radius = 5e-3,
                    .length = 10e-3};
  group.centroid = group.cylinder.p_LC;
  return group;
}

/// A force across at B, what balances it at A: the force there, and moments.
LoadHistory lever(double at_a, double at_b = 0.0) {
  LoadHistory history;
  history.seats = {{.name = "A", .group = "bore_A", .kind = SeatKind::kBearing},
                   {.name = "B",
                    .group = "bore_B",
                    .kind = SeatKind::kBearing,
                    .p_LS = {kArm, 0.0, 0.0}}};
  InstantLoad load;
  load.wrenches.resize(2);
  load.wrenches[0].force = {0.0, -kForce, 0.0};
  load.wrenches[0].moment = {0.0, 0.0, at_a};
  load.wrenches[1].force = {0.0, kForce, 0.0};
  load.wrenches[1].moment = {0.0, 0.0, at_b};
  history.instants = {load};
  return history;
}

/// Takes another seat in, of a face.
LoadHistory with_face(LoadHistory history, const char* group, double moment) {
  history.seats.push_back(
      {.name = "drive", .group = group, .kind = SeatKind::kTraction});
  history.instants[0].wrenches.push_back({.moment = {0.0, 0.0, moment}});
  return history;
}

std::vector<HoldingGroups> holds_of(LoadHistory history) {
  hold_clamped_seat({bore("bore_A", 0.0), bore("bore_B", kArm)}, kArm, history);
  return holding_groups(history);
}

const std::vector<HoldingGroups> kBoth{{"bore_A", "bore_B"}};

TEST(ClampedSeat, HoldsTheLeverAlone) {
  LoadHistory history = lever(-kForce * kArm);
  hold_clamped_seat({bore("bore_A", 0.0), bore("bore_B", kArm)}, kArm, history);
  EXPECT_EQ(holding_groups(history), std::vector<HoldingGroups>{{"bore_A"}});
  ASSERT_EQ(history.notes.size(), 1u);
  EXPECT_TRUE(history.notes[0].starts_with("bore_A counts as what alone"));
  EXPECT_EQ(history.hold(0.3).held.rows(), 12);
}

TEST(ClampedSeat, FrictionHoldsNothing) {
  EXPECT_EQ(holds_of(lever(-0.02 * kForce * kArm)), kBoth);
  EXPECT_EQ(holds_of(lever(-kForce * kArm, 0.02 * kForce * kArm)),
            std::vector<HoldingGroups>{{"bore_A"}});
}

TEST(ClampedSeat, OfTwoNobodyKnowsWhichHolds) {
  EXPECT_EQ(holds_of(lever(-0.5 * kForce * kArm, -0.5 * kForce * kArm)), kBoth);
  // More than friction, less than what turns a lever.
  EXPECT_EQ(holds_of(lever(-0.05 * kForce * kArm)), kBoth);
}

// Moments across the axis are those of a wide bore.
TEST(ClampedSeat, MomentsAcrossTheAxisDoNotTurnIt) {
  LoadHistory history = lever(0.0);
  history.instants[0].wrenches[0].moment = {kForce * kArm, kForce * kArm, 0.0};
  EXPECT_EQ(holds_of(history), kBoth);
}

// A beam that is welded at its face A: beside one pin any moment counts.
TEST(ClampedSeat, FaceThatTakesAMoment) {
  for (const double share : {1.0, 1e-3}) {
    LoadHistory history = lever(-share * kForce * kArm);
    history.seats[0].kind = SeatKind::kTraction;
    EXPECT_EQ(holds_of(history), std::vector<HoldingGroups>{{"bore_A"}});
  }
  LoadHistory history = lever(0.0);
  history.seats[0].kind = SeatKind::kTraction;
  EXPECT_EQ(holds_of(history), std::vector<HoldingGroups>{{"bore_B"}});
  EXPECT_FALSE(history.hold);
}

// A drive at the bore holds the lever, with no moment while that is straight.
TEST(ClampedSeat, BoreWithADrive) {
  const std::vector<HoldingGroups> at_a{{"bore_A"}};
  EXPECT_EQ(holds_of(with_face(lever(0.0), "bore_A", 0.0)), at_a);
  EXPECT_EQ(holds_of(with_face(lever(0.0), "bore_A", -kForce * kArm)), at_a);
  EXPECT_EQ(
      holds_of(with_face(with_face(lever(0.0), "bore_A", 0.0), "bore_B", 0.0)),
      kBoth);
}

// Forces off the middle of their face hold nothing.
TEST(ClampedSeat, ForceOnAFace) {
  LoadHistory history =
      with_face(lever(-kForce * kArm), "end", 0.5 * kForce * kArm);
  for (Seat& seat : history.seats) seat.kind = SeatKind::kTraction;
  history.seats[2].name = "force S";
  GroupGeometry end;
  end.name = "end";
  hold_clamped_seat({bore("bore_A", 0.0), bore("bore_B", kArm), end}, kArm,
                    history);
  EXPECT_EQ(holding_groups(history), std::vector<HoldingGroups>{{"bore_A"}});
}

// A force's seat in a bore holds nothing.
TEST(ClampedSeat, ForceInABore) {
  LoadHistory history = lever(0.0);
  history.seats[1].name = "force S";
  EXPECT_EQ(holds_of(history), std::vector<HoldingGroups>{{"bore_A"}});
  hold_clamped_seat({bore("bore_A", 0.0), bore("bore_B", kArm)}, kArm, history);
  ASSERT_EQ(history.notes.size(), 1u);
  EXPECT_NE(history.notes[0].find("relative to bore_A, clamped at which"),
            std::string::npos);
}

// A drive turns it at a face of its own: which pin holds it is not known.
TEST(ClampedSeat, MomentWithoutForceHoldsNoPlace) {
  LoadHistory history = with_face(lever(0.0), "hub", -kForce * kArm);
  GroupGeometry hub;
  hub.name = "hub";
  hold_clamped_seat({bore("bore_A", 0.0), bore("bore_B", kArm), hub}, kArm,
                    history);
  EXPECT_EQ(holding_groups(history), kBoth);
}

}  // namespace
}  // namespace clevis::loads
