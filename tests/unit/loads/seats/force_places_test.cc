#include "loads/seats/force_places.h"

#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace clevis::loads {
namespace {

using Eigen::Vector3d;

/// A bore of 20 mm, 10 mm long.
GroupGeometry bore(const std::string& name, const Vector3d& at) {
  GroupGeometry group;
  group.name = name;
  group.is_cylinder = true;
  group.cylinder = {.p_LC = at,
                    .axis_L = Vector3d::UnitZ(),
                    .radius = 10e-3,
                    .length = 10e-3};
  group.centroid = at;
  group.points.resize(3, 2);
  group.points << at + Vector3d(-10e-3, -10e-3, -5e-3),
      at + Vector3d(10e-3, 10e-3, 5e-3);
  return group;
}

/// A lever with bores at 0 and at 120 mm, and a force on it.
struct Lever {
  Lever() {
    mechanism::ConstantForce load;
    load.name = "load";
    load.point.body = 0;
    definition.bodies.resize(1);
    definition.elements.emplace_back(load);
    part.force_seats = {{"load", "bore_A", {}}};
  }

  /// @param force  of each instant, in the frame of the body [N].
  /// @param at  point of attack [m].
  std::vector<std::string> notes(const std::vector<Vector3d>& forces,
                                 const Vector3d& at) {
    mechanism::Motion motion;
    double angle = 0.3;  // the body stands turned and away from its origin
    for (const Vector3d& force : forces) {
      mechanism::Instant& instant = motion.instants.emplace_back();
      mechanism::Pose& pose = instant.bodies.emplace_back().pose;
      pose.R_WL =
          Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
      pose.p_WL = {0.4, -0.2, 0.0};
      mechanism::ElementState& state = instant.elements.emplace_back();
      state.actions[1] = {.body = 0,
                          .p_W = pose.p_WL + pose.R_WL * at,
                          .f_W = pose.R_WL * force,
                          .t_W = Vector3d(0.0, 0.0, 5.0)};
      angle += 1.0;
    }
    const SeatContext context{definition, 0, part, groups, 0.14};
    return off_face_notes(context, force_seats(context), motion);
  }

  mechanism::MechanismDefinition definition;
  part::PartDefinition part;
  std::vector<GroupGeometry> groups = {bore("bore_A", Vector3d::Zero()),
                                       bore("bore_B", {0.12, 0.0, 0.0})};
};

const Vector3d kAcross(0.0, -4000.0, 0.0);

TEST(ForcePlaces, AForceOnTheOtherBoreIsTold) {
  Lever lever;
  const Vector3d at_b(0.12, 0.0, 0.0);
  const auto notes = lever.notes({kAcross}, at_b);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0],
            "force load passes \"bore_A\" 120 mm from its middle, and the face "
            "is 20 mm large: it takes the force as if a rigid arm carried it "
            "there. At the force's point is \"bore_B\": forces = { \"load\" = "
            "{ face = \"bore_B\" } } if that is meant");
  lever.part.force_seats[0].group = "bore_B";
  EXPECT_TRUE(lever.notes({kAcross}, at_b).empty());
}

TEST(ForcePlaces, AForceMayBeMovedAlongItsLine) {
  Lever lever;
  EXPECT_TRUE(
      lever.notes({{500.0, 0.0, 0.0}}, Vector3d(0.12, 0.0, 0.0)).empty());
  EXPECT_TRUE(lever.notes({kAcross}, Vector3d(0.0, 0.3, 0.0)).empty());
}

TEST(ForcePlaces, BesideTheMiddleButOnTheFaceIsNoMistake) {
  Lever lever;
  EXPECT_TRUE(lever.notes({kAcross}, Vector3d(0.019, 0.0, 0.0)).empty());
  const auto notes = lever.notes({kAcross}, Vector3d(0.031, 0.0, 0.0));
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("31 mm from its middle"), std::string::npos);
  EXPECT_NE(notes[0].find("correct its point"), std::string::npos);
}

TEST(ForcePlaces, BesideTheMiddleOfABoresLengthIsTold) {
  Lever lever;
  EXPECT_TRUE(lever.notes({kAcross}, Vector3d(0.0, 0.0, 1.9e-4)).empty());
  const auto notes = lever.notes({kAcross}, Vector3d(0.0, 0.3, 5e-3));
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0],
            "force load acts 5 mm from the middle of \"bore_A\" along its axis "
            "(50 % of its length): it bends the part across; if that is not "
            "meant, correct its point");
  // Along the axis it may be moved.
  EXPECT_TRUE(
      lever.notes({{0.0, 0.0, 500.0}}, Vector3d(0.0, 0.0, 5e-3)).empty());
}

// Where a small force of some instant points counts for nothing, nor does a
// moment without a force.
TEST(ForcePlaces, TheForcesThatCountAreLookedAt) {
  Lever lever;
  const Vector3d at(0.12, 0.0, 0.0), along(4000.0, 0.0, 0.0);
  EXPECT_TRUE(lever.notes({along, 0.05 * kAcross}, at).empty());
  EXPECT_EQ(lever.notes({along, 0.5 * kAcross}, at).size(), 1u);
  EXPECT_TRUE(lever.notes({Vector3d::Zero()}, at).empty());
}

}  // namespace
}  // namespace clevis::loads
