// Slides that lead many times the links' lengths away: nothing of an open chain
// depends on that.
#include <gtest/gtest.h>

#include "mechanism/simulate.h"
#include "support/four_bar.h"
#include "support/newton_euler.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

using Eigen::Vector3d;

/// An arm that rocks by 1 deg, a cart on it at `rate`, a pendulum below.
MechanismDefinition cart_on_arm(double rate) {
  MechanismDefinition m;
  m.bodies = {testing::uniform_bar("arm", Vector3d::Zero(), 0.0, 0.2),
              testing::uniform_bar("cart", {0.1, 0.0, 0.0}, 0.0, 0.1),
              testing::uniform_bar("pendulum", {0.1, 0.0, 0.0}, -1.0, 0.3)};
  m.joints = {testing::pin("pivot", kGround, 0, 0.0, 0.0),
              {.name = "rail",
               .type = JointType::kPrismatic,
               .body_a = 0,
               .body_b = 1,
               .frame_a = testing::slide(1.0),
               .frame_b = testing::slide(1.0),
               .place = "rail"},
              testing::pin("hinge", 1, 2, 0.0, 0.0)};
  m.gravity_W = {0.0, -9.81, 0.0};
  DriveDefinition rocking;
  rocking.joint = 0;
  rocking.law = DriveLaw::kSine;
  rocking.amplitude = 0.0175;
  rocking.frequency = 0.5;
  rocking.start = 0.2;
  m.drives = {rocking};
  m.initial_joints = {
      {.joint = 1, .position = {}, .rate = rate, .place = "initial"}};
  return m;
}

TEST(FarTravel, ReactionsOfAnOpenChainBalanceAndAreUnique) {
  for (const double rate : {1.0, 15.0, 150.0, 500.0}) {
    const MechanismDefinition m = cart_on_arm(rate);
    const Motion motion =
        simulate(m, {.duration = 2.0, .instants = 41, .tolerance = 1e-8});
    for (const Instant& at : motion.instants) {
      EXPECT_LT(testing::imbalance(m, at), 1e-9) << rate << " " << at.t;
      for (const JointReaction& joint : at.joints) EXPECT_TRUE(joint.unique);
    }
  }
}

TEST(FarTravel, OpenChainsStartFarAway) {
  for (const double x : {2.0, 3.0, 10.0, 20.0, 50.0, 300.0}) {
    MechanismDefinition m = cart_on_arm(0.0);
    m.initial_joints[0].position = x;
    const Motion motion = simulate(m, {.duration = 0.1, .instants = 2});
    EXPECT_NEAR(motion.instants[0].bodies[1].pose.p_WL.x(), x, 1e-9 * x);
  }
}

// A body more than joints close loops: a parallelogram coasts through its line.
TEST(FarTravel, ALoopWithAFreeBodyIsALoop) {
  MechanismDefinition m = testing::four_bar(
      {.ground = 2.0, .crank = 1.0, .coupler = 2.0, .rocker = 1.0}, 0.5);
  m.bodies.push_back(testing::uniform_bar("free", {5.0, 0.0, 0.0}, 0.0, 1.0));
  m.gravity_W.setZero();
  m.bodies[0].placement.R_WL = m.bodies[2].placement.R_WL =
      testing::turned(0.5);
  m.bodies[1].placement.R_WL.setIdentity();
  m.bodies[1].placement.p_WL = m.bodies[0].placement.R_WL.col(0);
  m.drives.clear();
  m.initial_joints = {
      {.joint = 0, .position = {}, .rate = -1.0, .place = "initial"}};
  const Motion motion = simulate(m, {.duration = 1.0});
  ASSERT_EQ(motion.change_points.size(), 1u);
  EXPECT_NEAR(motion.change_points[0].t, 0.5, 1e-8);
}

}  // namespace
}  // namespace clevis::mechanism
