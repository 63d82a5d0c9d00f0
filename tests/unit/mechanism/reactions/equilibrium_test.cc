// Balance of one instant, against statics and Euler's equations by hand.
#include "mechanism/reactions/equilibrium.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
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

/// Wheels 0 and 1 on the ground, 90 mm apart, the first half as large; a torque
/// of 24 N m on the second is held by a drive of the first.
struct Gears {
  Gears() {
    m.dimension = SpaceDimension::kSpatial;
    m.bodies.resize(2);
    m.joints = {testing::pin("1", kGround, 0, 0.0, 0.0),
                testing::pin("2", kGround, 1, 0.0, 0.0)};
    m.joints[1].frame_a.p_LJ = {0.09, 0.0, 0.0};
    m.bodies[1].placement.p_WL = {0.09, 0.0, 0.0};
    for (BodyDefinition& body : m.bodies) body.mass_properties.mass = 1e-9;
    CouplingDefinition& mesh = m.couplings.emplace_back();
    mesh.joint_2 = 1;
    mesh.ratio = -2.0;
    mesh.teeth = ToothGeometry{.pressure_angle = kPressureAngle,
                               .helix_angle = 0.0,
                               .mid_face = std::nullopt};
    m.drives = {drive_of(0)};
  }

  Equilibrium::Solution solve() const {
    Placed placed(m, Motions::kSpatial);
    placed.applied[2].w = {0.0, 0.0, 24.0};
    return placed.solve();
  }

  static constexpr double kPressureAngle = 20.0 / 180.0 * std::numbers::pi;
  MechanismDefinition m;
};

// 24 N m on 60 mm are 400 N across, and 400 N tan 20° press the wheels apart;
// the reaction on each wheel is what balances that.
TEST(ToothForces, OfSpurGearsLoadTheBearings) {
  const Equilibrium::Solution found = Gears().solve();
  const double apart = 400.0 * std::tan(Gears::kPressureAngle);
  // Wheel 2 pushes against +y at the pitch point, on its side of axis 2.
  const auto& teeth = found.couplings[0].teeth;
  ASSERT_TRUE(teeth);
  EXPECT_LT((teeth->p_W - Vector3d(0.03, 0.0, 0.0)).norm(), kRoundOff);
  EXPECT_LT((teeth->f_W - Vector3d(-apart, -400.0, 0.0)).norm(), 1e-9);
  EXPECT_LT((found.joints[0].f_W - Vector3d(apart, 400.0, 0.0)).norm(), 1e-6);
  EXPECT_LT((found.joints[1].f_W + Vector3d(apart, 400.0, 0.0)).norm(), 1e-6);
  EXPECT_LT(found.joints[0].t_W.norm(), 1e-9);
  EXPECT_NEAR(found.efforts[0], 12.0, 1e-9);
}

// A helix of 30°: tan 20°/cos 30° apart and tan 30° along. The thrust on a
// right-handed wheel pushed towards −y at +x goes along +z, and turns its shaft
// over by its arm.
TEST(ToothForces, OfHelicalGearsPushAlong) {
  Gears gears;
  const double helix = std::numbers::pi / 6.0;
  gears.m.couplings[0].teeth->helix_angle = helix;
  gears.m.couplings[0].teeth->mid_face = 0.01;
  const Equilibrium::Solution found = gears.solve();
  const double apart =
      400.0 * std::tan(Gears::kPressureAngle) / std::cos(helix);
  const double along = 400.0 * std::tan(helix);
  const auto& teeth = *found.couplings[0].teeth;
  const Vector3d force(-apart, -400.0, along), pitch(0.03, 0.0, 0.01);
  EXPECT_LT((teeth.p_W - pitch).norm(), kRoundOff);
  EXPECT_LT((teeth.f_W - force).norm(), 1e-9);
  EXPECT_LT((found.joints[0].f_W + force).norm(), 1e-6);
  const Vector3d moment = pitch.cross(force);
  EXPECT_NEAR(found.joints[0].t_W.x(), -moment.x(), 1e-6);
  EXPECT_NEAR(found.joints[0].t_W.y(), -moment.y(), 1e-6);
  EXPECT_NEAR(found.joints[0].t_W.z(), 0.0, 1e-9);
  EXPECT_NEAR(found.efforts[0], 12.0, 1e-9);
}

// A ring of 180 mm round its pinion of 90 mm: teeth push the pinion away from
// the pitch point towards its own axis.
TEST(ToothForces, PushAPinionIntoItsRing) {
  Gears gears;
  gears.m.couplings[0].ratio = 2.0;
  const Equilibrium::Solution found = gears.solve();
  const double force = 24.0 / 0.18;
  const auto& teeth = *found.couplings[0].teeth;
  EXPECT_LT((teeth.p_W - Vector3d(-0.09, 0.0, 0.0)).norm(), kRoundOff);
  EXPECT_NEAR(teeth.f_W.x(), force * std::tan(Gears::kPressureAngle), 1e-9);
  EXPECT_NEAR(std::abs(teeth.f_W.y()), force, 1e-9);
  EXPECT_NEAR(-0.09 * teeth.f_W.y(), 12.0, 1e-9);
  EXPECT_NEAR(found.efforts[0], -12.0, 1e-9);
}

// The rack along x under the pinion at its origin, 20 mm of radius.
TEST(ToothForces, OfARackPressOnItsGuide) {
  Gears gears;
  MechanismDefinition& m = gears.m;
  m.joints[0].type = JointType::kPrismatic;
  m.joints[0].frame_a.R_LJ = m.joints[0].frame_b.R_LJ =
      Eigen::AngleAxisd(std::numbers::pi / 2.0, Vector3d::UnitY())
          .toRotationMatrix();
  m.couplings[0].ratio = 0.02;
  const Equilibrium::Solution found = gears.solve();
  // The pinion turned by +1 moves its lower side by +20 mm.
  const auto& teeth = *found.couplings[0].teeth;
  EXPECT_LT((teeth.p_W - Vector3d(0.09, -0.02, 0.0)).norm(), kRoundOff);
  const double apart = 1200.0 * std::tan(Gears::kPressureAngle);
  EXPECT_LT((teeth.f_W - Vector3d(1200.0, -apart, 0.0)).norm(), 1e-9);
  EXPECT_LT((found.joints[1].f_W - teeth.f_W).norm(), 1e-6);
  EXPECT_NEAR(found.joints[0].f_W.y(), apart, 1e-6);
  // About the guide's point the teeth turn the rack.
  const Vector3d moment = teeth.p_W.cross(teeth.f_W);
  EXPECT_NEAR(found.joints[0].t_W.z(), -moment.z(), 1e-6);
  EXPECT_NEAR(found.efforts[0], -1200.0, 1e-9);
}

}  // namespace
}  // namespace clevis::mechanism
