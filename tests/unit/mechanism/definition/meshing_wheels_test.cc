#include "mechanism/definition/meshing_wheels.h"

#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace clevis::mechanism {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A joint with z as its axis on both bodies, at a point of a and at b's
/// origin.
JointDefinition joint(JointType type, BodyIndex a, BodyIndex b,
                      const Vector3d& on_a) {
  JointDefinition joint;
  joint.type = type;
  joint.body_a = a;
  joint.body_b = b;
  joint.frame_a.p_LJ = on_a;
  return joint;
}

CouplingDefinition coupling(double ratio) {
  CouplingDefinition coupling;
  coupling.joint_2 = 1;
  coupling.ratio = ratio;
  coupling.teeth = ToothGeometry{};
  return coupling;
}

using Joints = std::vector<JointDefinition>;
constexpr auto kRevolute = JointType::kRevolute;

/// Wheels 0 and 1 on the ground, 90 mm apart.
Joints two_wheels(double beside = 0.0) {
  return {joint(kRevolute, kGround, 0, Vector3d::Zero()),
          joint(kRevolute, kGround, 1, {0.09, 0.0, beside})};
}

TEST(MeshingWheels, OnOneBody) {
  Joints joints = two_wheels();
  std::swap(joints[1].body_a, joints[1].body_b);
  std::swap(joints[1].frame_a, joints[1].frame_b);
  const auto wheels = meshing_wheels(joints, coupling(-2.0));
  ASSERT_TRUE(wheels);
  EXPECT_EQ(wheels->wheel_1, 0);
  EXPECT_EQ(wheels->wheel_2, 1);
  EXPECT_EQ(wheels->carrier_1, kGround);
  EXPECT_EQ(wheels->carrier_2, kGround);
}

// An arm of 0.2 m, turned by 90°, and on its hub the second wheel.
TEST(MeshingWheels, OnBodiesThatWeldsJoin) {
  const BodyIndex arm = 2, hub = 3;
  Joints joints{joint(kRevolute, kGround, 0, {-0.05, 0.2, 0.0}),
                joint(kRevolute, hub, 1, {0.01, 0.0, 0.0}),
                joint(JointType::kWeld, arm, hub, {0.2, 0.0, 0.0}),
                joint(JointType::kWeld, kGround, arm, Vector3d::Zero())};
  joints[3].frame_a.R_LJ =
      AngleAxisd(std::numbers::pi / 2.0, Vector3d::UnitZ()).toRotationMatrix();
  const auto wheels = meshing_wheels(joints, coupling(-2.0));
  ASSERT_TRUE(wheels);
  EXPECT_EQ(wheels->carrier_1, kGround);
  EXPECT_EQ(wheels->carrier_2, hub);
  // The second wheel stands at (0, 0.21).
  EXPECT_NEAR(pitch_circles(joints, coupling(-2.0)).distance,
              std::hypot(0.05, 0.01), 1e-15);
  joints.pop_back();
  EXPECT_FALSE(meshing_wheels(joints, coupling(-2.0)));
}

TEST(MeshingWheels, NoneWhereBothJointsJoinTheSameBodies) {
  Joints joints = two_wheels();
  joints[1].body_b = 0;
  EXPECT_FALSE(meshing_wheels(joints, coupling(-2.0)));
}

// r1 ω1 = r2 ω2 about the pitch point.
TEST(PitchCircles, OfExternalAndInternalMeshes) {
  const auto of = [](double ratio) {
    return pitch_circles(two_wheels(), coupling(ratio));
  };
  EXPECT_NEAR(of(-2.0).radius_1(), 0.03, 1e-15);
  EXPECT_NEAR(of(-2.0).radius_2(), 0.06, 1e-15);
  EXPECT_FALSE(of(-2.0).is_internal());
  EXPECT_NEAR(of(3.0).radius_1(), 0.045, 1e-15);  // the pinion
  EXPECT_NEAR(of(3.0).radius_2(), 0.135, 1e-15);
  EXPECT_TRUE(of(3.0).is_internal());
  EXPECT_NEAR(of(0.25).radius_1(), 0.12, 1e-15);  // the ring
  EXPECT_NEAR(of(0.25).radius_2(), 0.03, 1e-15);
  EXPECT_TRUE(of(0.25).is_internal());
}

// A wheel that is its joint's body a turns by minus the angle; so does one
// whose axis points the other way.
TEST(PitchCircles, KnowWhichWayWheelsTurn) {
  Joints swapped = two_wheels();
  std::swap(swapped[0].body_a, swapped[0].body_b);
  std::swap(swapped[0].frame_a, swapped[0].frame_b);
  EXPECT_FALSE(pitch_circles(swapped, coupling(2.0)).is_internal());
  Joints turned = two_wheels();
  const Matrix3d over =
      AngleAxisd(std::numbers::pi, Vector3d::UnitX()).toRotationMatrix();
  turned[0].frame_a.R_LJ = turned[0].frame_b.R_LJ = over;
  EXPECT_FALSE(pitch_circles(turned, coupling(2.0)).is_internal());
  EXPECT_NEAR(pitch_circles(turned, coupling(2.0)).radius_1(), 0.03, 1e-15);
}

std::string misfit(const Joints& joints, const CouplingDefinition& coupling) {
  const auto found = tooth_misfit(joints, coupling);
  return found ? found->what : "";
}

void expect_misfit(const Joints& joints, const CouplingDefinition& coupling,
                   const std::string& wanted) {
  const std::string what = misfit(joints, coupling);
  EXPECT_NE(what.find(wanted), std::string::npos) << what;
}

TEST(ToothMisfit, OfAxes) {
  EXPECT_EQ(misfit(two_wheels(), coupling(-2.0)), "");
  expect_misfit(two_wheels(), coupling(1.0), "turn as one");
  Joints bevel = two_wheels();
  bevel[1].frame_a.R_LJ = AngleAxisd(0.1, Vector3d::UnitX()).toRotationMatrix();
  expect_misfit(bevel, coupling(-2.0), "not parallel");
  Joints coaxial = two_wheels();
  coaxial[1].frame_a.p_LJ = {0.0, 0.0, 0.05};
  expect_misfit(coaxial, coupling(-2.0), "on one axis");
}

TEST(ToothMisfit, OfPointsThatDoNotLieSideBySide) {
  CouplingDefinition beside = coupling(-2.0);
  expect_misfit(two_wheels(0.02), beside, "20 mm apart");
  beside.teeth->mid_face = 0.01;
  EXPECT_EQ(misfit(two_wheels(0.02), beside), "");
}

TEST(ToothMisfit, OfRacksAndOtherJoints) {
  Joints rack = two_wheels();
  rack[0].type = JointType::kPrismatic;
  expect_misfit(rack, coupling(0.02), "does not slide across");
  rack[0].frame_a.R_LJ =
      AngleAxisd(std::numbers::pi / 2.0, Vector3d::UnitY()).toRotationMatrix();
  EXPECT_EQ(misfit(rack, coupling(0.02)), "");
  rack[1].type = JointType::kCylindrical;
  expect_misfit(rack, coupling(0.02), "move otherwise");
}

}  // namespace
}  // namespace clevis::mechanism
