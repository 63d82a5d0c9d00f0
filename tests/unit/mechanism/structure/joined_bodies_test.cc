#include "mechanism/structure/joined_bodies.h"

#include <gtest/gtest.h>

#include "support/landing_gear.h"

namespace clevis::mechanism {
namespace {

using namespace testing;

/// Two bodies, and a joint between them.
MechanismDefinition pair(JointType type) {
  MechanismDefinition m;
  m.bodies.resize(2);
  m.joints.resize(1);
  m.joints[0].type = type;
  m.joints[0].body_a = 0;
  m.joints[0].body_b = 1;
  return m;
}

TEST(JoinedBodies, LandingGearHangsTogetherAndItsCylinderIsStiff) {
  const MechanismDefinition gear = landing_gear();
  const JoinedBodies joined = joined_bodies(gear);
  ASSERT_EQ(joined.moving.size(), 1u);
  EXPECT_EQ(joined.moving[0].size(), gear.bodies.size());
  // The rod in its driven cylinder, the wheel welded to its arm.
  EXPECT_EQ(joined.stiffly.size(), 2u);
  for (const auto& group : joined.stiffly) EXPECT_EQ(group.size(), 2u);
  // It bends as one whoever holds the rod's way.
  MechanismDefinition released = gear;
  released.drives.clear();
  EXPECT_EQ(joined_bodies(released).stiffly.size(), 2u);
}

// What slides along an axis hands bending on, a hinge only where it is driven.
TEST(JoinedBodies, SlidesJoinStiffly) {
  MechanismDefinition m = pair(JointType::kRevolute);
  const auto is_stiff = [&](JointType type) {
    m.joints[0].type = type;
    return !joined_bodies(m).stiffly.empty();
  };
  EXPECT_TRUE(is_stiff(JointType::kPrismatic));
  EXPECT_TRUE(is_stiff(JointType::kCylindrical));
  EXPECT_FALSE(is_stiff(JointType::kRevolute));
  EXPECT_FALSE(is_stiff(JointType::kPlanar));
  EXPECT_FALSE(is_stiff(JointType::kSpherical));
  m.drives.emplace_back();
  m.drives[0].joint = 0;
  EXPECT_TRUE(is_stiff(JointType::kRevolute));
  EXPECT_FALSE(is_stiff(JointType::kUniversal));
}

// A bushing hands moments on, beside a ball or alone; a ball does not.
TEST(JoinedBodies, BushingsJoinElastically) {
  MechanismDefinition m = pair(JointType::kSpherical);
  EXPECT_TRUE(joined_bodies(m).elastically.empty());
  BushingElement bushing;
  bushing.a.body = 0;
  bushing.b.body = 1;
  m.elements.emplace_back(bushing);
  EXPECT_EQ(joined_bodies(m).elastically.size(), 1u);
  EXPECT_TRUE(joined_bodies(m).stiffly.empty());
  m.joints.clear();
  EXPECT_EQ(joined_bodies(m).elastically.size(), 1u);
}

// A spring on a hinge hands its moment on; a damper there, or a spring on one
// of two angles, does not.
TEST(JoinedBodies, SpringsOnAnglesJoinElastically) {
  MechanismDefinition m = pair(JointType::kRevolute);
  const auto joined = [&](JointType type, double stiffness) {
    m.joints[0].type = type;
    LineElement element;
    element.line = {.kind = ElementLine::Kind::kJoint, .joint = 0};
    element.law = SpringLaw{.stiffness = stiffness, .damping = 1.0};
    m.elements = {element};
    return joined_bodies(m).elastically.size();
  };
  EXPECT_EQ(joined(JointType::kRevolute, 100.0), 1u);
  EXPECT_EQ(joined(JointType::kRevolute, 0.0), 0u);
  EXPECT_EQ(joined(JointType::kUniversal, 100.0), 0u);
}

}  // namespace
}  // namespace clevis::mechanism
