#include "loads/holds/following_forces.h"

#include <utility>

#include <gtest/gtest.h>

namespace clevis::loads {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using namespace mechanism;

constexpr double kLength = 0.1;   // of the link, along x [m]
constexpr double kForce = 200.0;  // presses [N]

/// Part 0 and link 1 meet in the origin, link and ground at its other end.
struct Linked {
  MechanismDefinition definition;
  Instant instant;
  part::PartDefinition part;
  std::vector<GroupGeometry> groups;

  explicit Linked(JointType type, JointType far = JointType::kSpherical) {
    definition.bodies.resize(2);
    JointDefinition near{.name = "B", .type = type, .body_a = 0, .body_b = 1};
    JointDefinition end{
        .name = "C", .type = far, .body_a = kGround, .body_b = 1};
    end.frame_a.p_LJ = end.frame_b.p_LJ = kLength * Vector3d::UnitX();
    definition.joints = {near, end};
    instant.bodies.resize(2);
    instant.joints.resize(2);
    instant.joints[0].f_W = kForce * Vector3d::UnitX();  // on the link
  }

  std::vector<FollowingForce> found() const {
    const JointDefinition& joint = definition.joints[0];
    const JointSeat seat{{0, &joint, &joint.frame_a, -1.0}, {.name = "B"}};
    return following_forces({definition, 0, part, groups, 1.0}, instant, {seat},
                            {}, 1);
  }
};

constexpr double kGain = kForce / kLength;

TEST(FollowingForces, LinkThatPressesPushesOnAcross) {
  const auto found = Linked(JointType::kSpherical).found();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].seat, 0u);
  const Matrix3d wanted = Vector3d(0.0, kGain, kGain).asDiagonal();
  EXPECT_LT((found[0].gain - wanted).norm(), 1e-12 * kGain);
}

TEST(FollowingForces, LinkThatPullsHoldsBack) {
  Linked linked(JointType::kSpherical);
  linked.instant.joints[0].f_W *= -1.0;
  EXPECT_NEAR(linked.found().at(0).gain(1, 1), -kGain, 1e-12 * kGain);
}

TEST(FollowingForces, HingeSwingsAboutItsAxisOnly) {
  const Matrix3d wanted = Vector3d(0.0, kGain, 0.0).asDiagonal();
  for (const JointType far : {JointType::kSpherical, JointType::kRevolute}) {
    const auto found = Linked(JointType::kRevolute, far).found();
    ASSERT_EQ(found.size(), 1u);
    EXPECT_LT((found[0].gain - wanted).norm(), 1e-12 * kGain);
  }
}

TEST(FollowingForces, WhatIsNoLinkBetweenTwoPinsFollowsNothing) {
  EXPECT_TRUE(Linked(JointType::kWeld).found().empty());
  EXPECT_TRUE(Linked(JointType::kPrismatic).found().empty());
  Linked loaded(JointType::kSpherical);
  loaded.instant.joints[0].f_W.y() = 0.2 * kForce;  // what else acts on it
  EXPECT_TRUE(loaded.found().empty());
  Linked third(JointType::kSpherical);
  third.definition.joints.push_back(
      {.name = "D", .type = JointType::kSpherical, .body_a = 1});
  EXPECT_TRUE(third.found().empty());
}

TEST(FollowingForces, TurnWithThePart) {
  Linked linked(JointType::kRevolute);
  Matrix3d& turned = linked.instant.bodies[0].pose.R_WL;
  turned << 0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0;
  EXPECT_NEAR(linked.found().at(0).gain(0, 0), kGain, 1e-12 * kGain);
}

// A rod of given length, and a ram between two points.
TEST(FollowingForces, RodsAndRams) {
  Linked linked(JointType::kDistance);
  linked.definition.joints[0].length = kLength;
  linked.definition.joints[0].frame_b.p_LJ = kLength * Vector3d::UnitX();
  EXPECT_NEAR(linked.found().at(0).gain(2, 2), kGain, 1e-12 * kGain);

  LineElement ram;
  ram.line = {.kind = ElementLine::Kind::kDistance,
              .a = {0, Vector3d::Zero()},
              .b = {kGround, kLength * Vector3d::UnitX()}};
  linked.definition.elements = {ram};
  ElementState state;
  state.actions[0] = {.body = 0, .f_W = -kForce * Vector3d::UnitX()};
  state.actions[1] = {.body = kGround, .p_W = kLength * Vector3d::UnitX()};
  linked.instant.elements = {state};
  const auto found =
      following_forces({linked.definition, 0, linked.part, linked.groups, 1.0},
                       linked.instant, {}, {ForceSeat{}}, 3);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].seat, 3u);
  EXPECT_NEAR(found[0].gain(1, 1), kGain, 1e-12 * kGain);
}

}  // namespace
}  // namespace clevis::loads
