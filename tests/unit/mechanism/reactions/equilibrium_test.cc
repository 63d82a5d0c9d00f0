// Balance of one instant, against statics and Euler's equations by hand.
#include "mechanism/reactions/equilibrium.h"

#include <numbers>

#include <gtest/gtest.h>

#include "mechanism/constraints/closed_joints.h"
#include "support/free_linkages.h"

namespace clevis::mechanism {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kRoundOff = 1e-12;  // of sums of a few numbers near one

DriveDefinition drive_of(int joint) {
  DriveDefinition drive;
  drive.joint = joint;
  drive.place = "drive";
  return drive;
}

/// A mechanism at rest in its placement, and the solver of its equilibrium.
/// Twists and wrenches are about M, here the mean of a body's joints, and in W
/// as long as P is W.
struct Placed {
  Placed(const MechanismDefinition& m, Motions motions)
      : frame(m),
        system(frame, m.drives, motions, ConstraintSystem::Drives::kAll),
        x(closed_joints(m, frame, 1e-12)),
        placed(system.place(x)),
        equilibrium(m, frame, system),
        twists(x.size()),
        accelerations(x.size()),
        applied(x.size()) {
    factor.compute(system.jacobian(placed), nullptr, frame.rank_threshold());
    EXPECT_LT((frame.R_WP - Matrix3d::Identity()).norm(), kRoundOff);
  }

  Equilibrium::Solution solve() const {
    return equilibrium.solve(x, placed, factor, twists, accelerations, applied);
  }

  SolvingFrame frame;
  ConstraintSystem system;
  Configuration x;
  std::vector<PlacedJoint> placed;
  Equilibrium equilibrium;
  numerics::JacobianFactor factor;
  std::vector<Twist> twists, accelerations, applied;
};

/// A level bar of 1 kg and 2 m on a driven hinge, its centre 0.3 m above the
/// plane of motion.
MechanismDefinition driven_bar() {
  MechanismDefinition m;
  m.dimension = SpaceDimension::kPlanar;
  m.bodies = {testing::uniform_bar("bar", Vector3d::Zero(), 0.0, 2.0)};
  m.bodies[0].mass_properties.p_LCm.z() = 0.3;
  m.joints = {testing::pin("O", kGround, 0, 0.0, 0.0)};
  m.drives = {drive_of(0)};
  m.gravity_W = {0.0, -10.0, 0.0};
  return m;
}

// The centre is 1 m from the hinge: centripetal −w², across it g + alpha; about
// the hinge the inertia is 1/3 m l² = 4/3 kg m².
TEST(Equilibrium, OfABarThatIsSwung) {
  Placed bar(driven_bar(), Motions::kInPlane);
  bar.twists[1].w.z() = 3.0;
  bar.accelerations[1].w.z() = 5.0;
  const Equilibrium::Solution found = bar.solve();
  const Vector3d force(-9.0, 10.0 + 5.0, 0.0);
  EXPECT_LT((found.joints[0].f_W - force).norm(), 15.0 * kRoundOff);
  ASSERT_EQ(found.efforts.size(), 1u);
  EXPECT_NEAR(found.efforts[0], 4.0 / 3.0 * 5.0 + 10.0, 15.0 * kRoundOff);
  EXPECT_TRUE(found.joints[0].unique);
}

// What the plane leaves out is carried by the hinge: forces at a height of
// 0.3 m turn about the axes in the plane.
TEST(Equilibrium, AcrossThePlane) {
  Placed bar(driven_bar(), Motions::kInPlane);
  bar.twists[1].w.z() = 3.0;
  const Equilibrium::Solution found = bar.solve();
  const Vector3d moment(-0.3 * 10.0, -0.3 * 9.0, 0.0);
  EXPECT_LT((found.joints[0].t_W - moment).norm(), 10.0 * kRoundOff);
}

// Euler's equations about a fixed axis: products of inertia turn with the
// rotor.
TEST(Equilibrium, OfARotorOutOfBalance) {
  MechanismDefinition m;
  m.dimension = SpaceDimension::kSpatial;
  BodyDefinition rotor =
      testing::uniform_bar("rotor", Vector3d::Zero(), 0.0, 1.0);
  const double xz = 0.02, yz = -0.05, zz = 0.4;
  rotor.mass_properties.p_LCm.setZero();
  rotor.mass_properties.inertia_LCm << 0.3, 0.0, xz, 0.0, 0.5, yz, xz, yz, zz;
  m.bodies = {rotor};
  m.joints = {testing::pin("O", kGround, 0, 0.0, 0.0)};
  m.drives = {drive_of(0)};
  Placed turning(m, Motions::kSpatial);
  const double w = 7.0, alpha = 11.0;
  turning.twists[1].w.z() = w;
  turning.accelerations[1].w.z() = alpha;
  const Equilibrium::Solution found = turning.solve();
  const Vector3d moment(xz * alpha - yz * w * w, yz * alpha + xz * w * w, 0.0);
  EXPECT_LT((found.joints[0].t_W - moment).norm(), 10.0 * kRoundOff);
  EXPECT_LT(found.joints[0].f_W.norm(), 10.0 * kRoundOff);
  EXPECT_NEAR(found.efforts[0], zz * alpha, 10.0 * kRoundOff);
}

// q_1 = ratio q_2: the teeth hold a moment T on wheel 2 by T/ratio on wheel 1,
// which the drive of wheel 1 holds.
TEST(Equilibrium, OfAGearPair) {
  const double ratio = -2.5, T = 4.0;
  MechanismDefinition m;
  m.dimension = SpaceDimension::kPlanar;
  m.bodies = {testing::uniform_bar("wheel_1", Vector3d::Zero(), 0.0, 1.0),
              testing::uniform_bar("wheel_2", {1.0, 0.0, 0.0}, 0.0, 1.0)};
  m.joints = {testing::pin("O_1", kGround, 0, 0.0, 0.0),
              testing::pin("O_2", kGround, 1, 1.0, 0.0)};
  CouplingDefinition gear;
  gear.joint_1 = 0;
  gear.joint_2 = 1;
  gear.ratio = ratio;
  m.couplings = {gear};
  m.drives = {drive_of(0)};
  Placed wheels(m, Motions::kInPlane);
  wheels.applied[2].w.z() = T;
  const Equilibrium::Solution found = wheels.solve();
  ASSERT_EQ(found.couplings.size(), 1u);
  EXPECT_NEAR(found.couplings[0].effort, T / ratio, 10.0 * kRoundOff);
  EXPECT_NEAR(found.couplings[0].t_1_W.z(), T / ratio, 10.0 * kRoundOff);
  EXPECT_NEAR(found.couplings[0].t_2_W.z(), -T, 10.0 * kRoundOff);
  EXPECT_NEAR(found.efforts[0], -T / ratio, 10.0 * kRoundOff);
}

// Two hinges on a line share a pull along it by their compliances a and b,
// which equilibrium leaves open; across it it does not.
TEST(Equilibrium, OfALinkOnTwoHinges) {
  const double a = 1e-8, b = 3e-8, pull = 800.0, weight = 60.0;
  MechanismDefinition m;
  m.dimension = SpaceDimension::kPlanar;
  m.bodies = {testing::uniform_bar("link", Vector3d::Zero(), 0.0, 1.0)};
  m.joints = {testing::pin("A", kGround, 0, 0.0, 0.0),
              testing::pin("B", kGround, 0, 1.0, 1.0)};
  for (const int j : {0, 1}) {
    JointCompliance compliance;
    compliance.force.setConstant(j == 0 ? a : b);
    compliance.moment.setConstant(1e-6);
    m.joints[static_cast<std::size_t>(j)].compliance = compliance;
  }
  Placed link(m, Motions::kInPlane);
  link.applied[1].v = {pull, -weight, 0.0};
  const Equilibrium::Solution found = link.solve();
  const JointReaction &at_a = found.joints[0], &at_b = found.joints[1];
  EXPECT_NEAR(at_a.f_W.x(), -pull * b / (a + b), pull * 1e-9);
  EXPECT_NEAR(at_b.f_W.x(), -pull * a / (a + b), pull * 1e-9);
  EXPECT_NEAR(at_a.f_W.y(), 0.5 * weight, weight * 1e-9);
  EXPECT_NEAR(at_b.f_W.y(), 0.5 * weight, weight * 1e-9);
  EXPECT_FALSE(at_a.unique_components[0]);
  EXPECT_TRUE(at_a.unique_components[1]);
  // by ln a and by ln b the share changes by a b / (a + b)² each
  const double spread =
      2.0 * std::numbers::ln2 * pull * a * b / ((a + b) * (a + b));
  EXPECT_NEAR(at_b.spread[0], spread, pull * 1e-9);
  EXPECT_NEAR(at_b.spread[1], 0.0, pull * 1e-9);
}

}  // namespace
}  // namespace clevis::mechanism
