#include "mechanism/constraints/solving_frame.h"

#include <gtest/gtest.h>

namespace clevis::mechanism {
namespace {

/// A rod of 0.4 m on a slide through a point of it.
MechanismDefinition sliding_rod(double joint_at, double centre, double drive) {
  MechanismDefinition m;
  m.bodies.resize(1);
  m.bodies[0].name = "rod";
  part::MassProperties& given = m.bodies[0].mass_properties;
  given.mass = 0.25;
  given.p_LCm = {centre, 0.0, 0.0};
  const double moment = given.mass * 0.4 * 0.4 / 12.0;
  given.inertia_LCm.diagonal() << 1e-6, moment, moment;
  m.joints.resize(1);
  m.joints[0].name = "guide";
  m.joints[0].type = JointType::kPrismatic;
  m.joints[0].body_a = kGround;
  m.joints[0].body_b = 0;
  m.joints[0].frame_b.p_LJ = {joint_at, 0.0, 0.0};
  m.drives.resize(1);
  m.drives[0].joint = 0;
  m.drives[0].law = DriveLaw::kConstant;
  m.drives[0].from = drive;
  return m;
}

// Of moments over a length of round-off a hold keeps none: the rod was pinned
// where its guide clamps it.
TEST(SolvingFrame, LengthOfABodyThatSlidesThroughItsMiddleIsNoRoundOff) {
  EXPECT_DOUBLE_EQ(SolvingFrame(sliding_rod(0.0, 0.0, 0.0)).length, 1.0);
  EXPECT_DOUBLE_EQ(SolvingFrame(sliding_rod(1e-17, -1e-17, 0.0)).length, 1.0);
  EXPECT_DOUBLE_EQ(SolvingFrame(sliding_rod(0.0, 1e-17, 1e-6)).length, 1.0);
  EXPECT_DOUBLE_EQ(SolvingFrame(sliding_rod(0.0, 0.03, 0.0)).length, 0.03);
  EXPECT_DOUBLE_EQ(SolvingFrame(sliding_rod(0.0, 0.0, 0.05)).length, 0.05);
}

}  // namespace
}  // namespace clevis::mechanism
