// Where the counterpart of a slide touches: by hand from the poses.
#include "loads/seats/slide_zone.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "loads/seats/part_seats.h"

namespace clevis::loads {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using mechanism::JointType;

/// A flat group: a rectangle about its centroid, or a slot's two walls.
GroupGeometry face(const std::string& name, const Vector3d& centroid,
                   const Vector3d& half_along, const Vector3d& half_across) {
  GroupGeometry group;
  group.name = name;
  group.centroid = centroid;
  const Vector3d area = 4.0 * half_along.cross(half_across);
  group.area = area.norm();
  group.area_vector = area;
  group.normal_square = area * area.transpose() / area.norm();
  group.points.resize(3, 4);
  group.points << centroid + half_along + half_across,
      centroid + half_along - half_across, centroid - half_along - half_across,
      centroid - half_along + half_across;
  return group;
}

GroupGeometry round(const std::string& name, const Vector3d& middle,
                    double length) {
  GroupGeometry group;
  group.name = name;
  group.is_cylinder = true;
  group.cylinder = {.p_LC = middle,
                    .axis_L = -Vector3d::UnitX(),
                    .radius = 5e-3,
                    .length = length};
  group.centroid = middle;
  group.area = 2.0 * std::numbers::pi * 5e-3 * length;
  return group;
}

Matrix3d z_to_x() {
  return Eigen::AngleAxisd(std::numbers::pi / 2.0, Vector3d::UnitY())
      .toRotationMatrix();
}

/// A guide (body 0) with a wall 100 mm long, x from −50 to 50 mm of its frame,
/// on which body 1 slides along x; both turned and moved in the world.
struct Guide {
  mechanism::MechanismDefinition definition;
  mechanism::Motion motion;
  part::PartDefinition part;
  std::vector<GroupGeometry> groups;
  SeatSpans spans;

  explicit Guide(JointType type = JointType::kPrismatic) {
    definition.bodies.resize(2);
    mechanism::JointDefinition joint;
    joint.name = "S";
    joint.type = type;
    joint.body_a = 0;
    joint.body_b = 1;
    joint.frame_a = {{-0.05, 0.0, 0.0}, z_to_x()};
    joint.frame_b = {{0.002, 0.0, 0.0}, z_to_x()};
    definition.joints = {joint};
    part.name = "guide";
    part.seats = {{"S", "wall"}};
    groups = {
        face("wall", {0.0, 0.01, 0.0}, {0.05, 0.0, 0.0}, {0.0, 0.0, 0.004})};
  }

  /// Adds an instant with the joint's point on body 1 at x of the guide.
  void at(double x) {
    mechanism::Instant instant;
    instant.t = static_cast<double>(motion.instants.size());
    const Matrix3d R =
        Eigen::AngleAxisd(0.6, Vector3d(1.0, 2.0, -1.0).normalized())
            .toRotationMatrix();
    const Vector3d p(0.1, -0.2, 0.3);
    instant.bodies.resize(2);
    instant.bodies[0].pose = {p, R};
    instant.bodies[1].pose = {p + R * Vector3d(x - 0.002, 0.0, 0.0), R};
    instant.joints.resize(1);
    motion.instants.push_back(instant);
  }

  LoadHistory history() const {
    const SeatContext context{definition, 0, part, groups, 0.1};
    const auto seats = joint_seats(context);
    LoadHistory result;
    for (const auto& seat : seats) result.seats.push_back(seat.seat);
    result.instants.resize(motion.instants.size());
    set_contact_zones(context, motion, spans, seats, result);
    return result;
  }
  std::string code() const {
    try {
      history();
    } catch (const Error& error) {
      return error.code();
    }
    return "none";
  }
};

TEST(SlideZone, LengthTravelsWithTheCounterpart) {
  Guide guide;
  guide.part.seats[0].slide.length = 0.02;
  guide.part.seats[0].slide.offset = 0.003;
  guide.at(-0.03);
  guide.at(0.01);
  const LoadHistory history = guide.history();
  ASSERT_TRUE(history.seats[0].slide);
  EXPECT_LT((history.seats[0].slide->along_L - Vector3d::UnitX()).norm(),
            1e-12);
  EXPECT_NEAR(std::abs(history.seats[0].slide->normal_L.y()), 1.0, 1e-12);
  const auto& first = history.instants[0].zones[0];
  const auto& second = history.instants[1].zones[0];
  EXPECT_NEAR(first.low[0], -0.037, 1e-12);
  EXPECT_NEAR(first.high[0], -0.017, 1e-12);
  EXPECT_NEAR(second.low[0], 0.003, 1e-12);
  EXPECT_NEAR(second.high[0], 0.023, 1e-12);
  EXPECT_EQ(first.low[1], -ContactZone::kAll);  // over the whole width
  EXPECT_TRUE(history.notes.empty());
}

TEST(SlideZone, WidthIsAboutTheJointsPoint) {
  Guide guide;
  guide.part.seats[0].slide.length = 0.02;
  guide.part.seats[0].slide.width = 0.005;
  guide.at(0.0);
  const auto zone = guide.history().instants[0].zones[0];
  EXPECT_NEAR(zone.low[1], -0.0025, 1e-12);
  EXPECT_NEAR(zone.high[1], 0.0025, 1e-12);
}

// What reaches beyond the wall touches nothing; the edge of the wall is none
// of the zone.
TEST(SlideZone, OverhangIsCutAndTold) {
  Guide guide;
  guide.part.seats[0].slide.length = 0.02;
  guide.at(0.0);
  guide.at(0.045);
  const LoadHistory history = guide.history();
  const auto& zone = history.instants[1].zones[0];
  EXPECT_NEAR(zone.low[0], 0.035, 1e-12);
  EXPECT_EQ(zone.high[0], ContactZone::kAll);
  ASSERT_EQ(history.notes.size(), 1u);
  EXPECT_NE(history.notes[0].find("75 % of its length"), std::string::npos)
      << history.notes[0];
}

TEST(SlideZone, CounterpartThatHasLeftTheWallIsRefused) {
  Guide guide;
  guide.part.seats[0].slide.length = 0.02;
  guide.at(0.065);
  EXPECT_EQ(guide.code(), "L007");
}

TEST(SlideZone, WithoutLengthItIsRefused) {
  Guide guide;
  guide.at(0.0);
  EXPECT_EQ(guide.code(), "L007");
  guide.part.seats[0].slide.length = 0.1;  // all of it
  EXPECT_EQ(guide.code(), "none");
  EXPECT_TRUE(is_whole(guide.history().instants[0].zones[0]));
}

// The counterpart's own seat tells: 30 mm from x = −6 to 24 of body 1, that is
// −8 to 22 mm from its joint's point; also under another angle about x.
TEST(SlideZone, CounterpartsOwnSeatTells) {
  Guide guide;
  part::PartDefinition block;
  block.name = "block";
  block.seats = {{"S", "foot"}};
  add_seat_spans(
      guide.definition, 1, block,
      {face("foot", {0.009, -0.01, 0.0}, {0.015, 0.0, 0.0}, {0.0, 0.0, 0.003})},
      guide.spans);
  guide.at(0.02);
  const auto zone = guide.history().instants[0].zones[0];
  EXPECT_NEAR(zone.low[0], 0.012, 1e-12);
  EXPECT_NEAR(zone.high[0], 0.042, 1e-12);
  EXPECT_NEAR(zone.low[1], -0.003, 1e-12);
  EXPECT_NEAR(zone.high[1], 0.003, 1e-12);
}

// The block's own foot lies on a longer wall all the time: all of it presses.
TEST(SlideZone, ShorterSideIsTouchedAllOver) {
  Guide block;
  block.groups = {
      face("wall", {0.0, 0.01, 0.0}, {0.01, 0.0, 0.0}, {0.0, 0.0, 0.004})};
  part::PartDefinition rail;
  rail.seats = {{"S", "rail"}};
  add_seat_spans(
      block.definition, 1, rail,
      {face("rail", {0.0, 0.01, 0.0}, {0.2, 0.0, 0.0}, {0.0, 0.0, 0.004})},
      block.spans);
  block.at(0.05);
  block.at(-0.04);
  for (const auto& instant : block.history().instants) {
    EXPECT_TRUE(is_whole(instant.zones[0]));
  }
}

// A rod in its guide: the length that the guide states travels on the rod, and
// stands still on the guide's own bore.
TEST(SlideZone, StatedByTheOtherPartItHoldsOnBoth) {
  Guide guide(JointType::kCylindrical);
  guide.groups = {round("bore_wall", Vector3d::Zero(), 0.1)};
  guide.part.seats = {{"S", "bore_wall"}};
  part::PartDefinition rod;
  rod.seats = {{"S", "round_rod"}};
  rod.seats[0].slide.length = 0.016;  // about the guide's joint point
  add_seat_spans(guide.definition, 1, rod,
                 {round("round_rod", Vector3d::Zero(), 0.3)}, guide.spans);
  guide.definition.joints[0].frame_a.p_LJ = {-0.02, 0.0, 0.0};
  guide.at(0.03);
  const auto zone = guide.history().instants[0].zones[0];
  EXPECT_NEAR(zone.low[0], -0.028, 1e-12);
  EXPECT_NEAR(zone.high[0], -0.012, 1e-12);
}

TEST(SlideZone, PinThatMaySlideButDoesNotFillsItsBore) {
  Guide guide(JointType::kCylindrical);
  guide.groups = {round("bore_wall", Vector3d::Zero(), 0.012)};
  guide.part.seats = {{"S", "bore_wall"}};
  guide.at(0.0);
  guide.at(0.0003);
  const LoadHistory history = guide.history();
  EXPECT_FALSE(history.seats[0].slide);
  EXPECT_EQ(history.notes.size(), 1u);
  guide.at(0.002);
  EXPECT_EQ(guide.code(), "L007");
}

// A plate on a table: a rectangle along x and y of the joint's frame.
TEST(SlideZone, PlanarJointsNeedBothSides) {
  Guide table(JointType::kPlanar);
  const Matrix3d z_to_y =
      Eigen::AngleAxisd(-std::numbers::pi / 2.0, Vector3d::UnitX())
          .toRotationMatrix();
  table.definition.joints[0].frame_a = {{0.0, 0.01, 0.0}, z_to_y};
  table.definition.joints[0].frame_b = {{0.002, 0.01, 0.0}, z_to_y};
  table.part.seats[0].slide.length = 0.02;
  table.at(0.01);
  EXPECT_EQ(table.code(), "L007");
  table.part.seats[0].slide.width = 0.004;
  const auto zone = table.history().instants[0].zones[0];
  EXPECT_NEAR(zone.low[0], 0.0, 1e-12);
  EXPECT_NEAR(zone.high[0], 0.02, 1e-12);
  EXPECT_NEAR(zone.low[1], -0.002, 1e-12);
  EXPECT_NEAR(zone.high[1], 0.002, 1e-12);
}

TEST(SlideZone, WallMustLieAlongTheSlide) {
  Guide guide;
  guide.part.seats[0].slide.length = 0.02;
  guide.groups = {
      face("wall", {0.0, 0.01, 0.0}, {0.05, 0.005, 0.0}, {0.0, 0.0, 0.004})};
  guide.at(0.0);
  EXPECT_EQ(guide.code(), "L003");
  Guide turning(JointType::kCylindrical);
  turning.at(0.0);
  EXPECT_EQ(turning.code(), "L002");  // a body that turns needs a cylinder
}

}  // namespace
}  // namespace clevis::loads
