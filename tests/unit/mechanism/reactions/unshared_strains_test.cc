// Links that spin or forces strain between joints whose reactions equilibrium
// leaves open.
#include "mechanism/reactions/unshared_strains.h"

#include <vector>

#include <gtest/gtest.h>

#include "mechanism/simulate.h"

namespace clevis::mechanism {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

JointDefinition hinge(const char* name, BodyIndex a, BodyIndex b,
                      const Vector3d& at) {
  JointDefinition joint;
  joint.name = name;
  joint.type = JointType::kRevolute;
  joint.body_a = a;
  joint.body_b = b;
  joint.frame_a.p_LJ = joint.frame_b.p_LJ = at;
  return joint;
}

BodyDefinition body(const char* name, double mass, const Vector3d& centre) {
  BodyDefinition body;
  body.name = name;
  body.place = name;
  body.mass_properties.mass = mass;
  body.mass_properties.p_LCm = centre;
  body.mass_properties.inertia_LCm = 1e-2 * mass * Matrix3d::Identity();
  return body;
}

/// A disc that a drive turns about z, and a link of 1 kg on two hinges to it,
/// 0.2 m apart along `way`.
MechanismDefinition spun_link(double speed, const Vector3d& way) {
  MechanismDefinition m;
  m.bodies = {body("disc", 5.0, Vector3d::Zero()),
              body("link", 1.0, Vector3d::Zero())};
  m.bodies[1].part = "link";
  m.joints = {hinge("O", kGround, 0, Vector3d::Zero()),
              hinge("A", 0, 1, -0.1 * way), hinge("B", 0, 1, 0.1 * way)};
  DriveDefinition drive;
  drive.joint = 0;
  drive.law = DriveLaw::kSpeed;
  drive.speed = speed;
  m.drives = {drive};
  m.dimension = SpaceDimension::kSpatial;
  return m;
}

std::vector<int> spun(const MechanismDefinition& m) {
  return simulate(m, {.duration = 0.01, .instants = 3}).unshared.spun;
}

TEST(UnsharedStrains, SpinStretchesALinkBetweenItsHinges) {
  EXPECT_EQ(spun(spun_link(200.0, Vector3d::UnitX())), std::vector<int>{1});
  EXPECT_TRUE(spun(spun_link(0.0, Vector3d::UnitX())).empty());
}

// m ω² d/8 beside a hundredth of what a hinge of the link bears of its weight,
// m g/2: from 1.40 rad/s on, however heavy the disc is.
TEST(UnsharedStrains, OfASlowLinkNone) {
  for (const double speed : {1.3, 1.5}) {
    MechanismDefinition m = spun_link(speed, Vector3d::UnitX());
    m.gravity_W = {0.0, 0.0, -9.81};
    EXPECT_EQ(spun(m).empty(), speed < 1.40) << speed;
  }
}

// Along its axis spin stretches nothing.
TEST(UnsharedStrains, OfHingesOnTheAxisOfSpinNone) {
  EXPECT_TRUE(spun(spun_link(200.0, Vector3d::UnitZ())).empty());
}

TEST(UnsharedStrains, ForcesOnElasticLinksBesideTheirJoints) {
  MechanismDefinition m = spun_link(0.0, Vector3d::UnitX());
  m.gravity_W = {0.0, 0.0, -9.81};
  m.bodies[1].compliance = LinkCompliance{
      .joints = {1, 2},
      .points = {-0.1 * Vector3d::UnitX(), 0.1 * Vector3d::UnitX()},
      .matrix = 1e-9 * Eigen::MatrixXd::Identity(12, 12)};
  const SimulationSettings settings{.duration = 0.01, .instants = 3};
  EXPECT_TRUE(simulate(m, settings).unshared.loaded.empty());
  LineElement spring;
  spring.name = "spring";
  spring.line.kind = ElementLine::Kind::kDistance;
  spring.line.a = {kGround, {0.0, 1.0, 0.0}};
  spring.line.b = {1, Vector3d::Zero()};
  spring.law = SpringLaw{.stiffness = 1e3, .free = 0.5};
  m.elements = {spring};
  EXPECT_EQ(simulate(m, settings).unshared.loaded, std::vector<int>{1});
  m.bodies[1].compliance->loads = {{0, Vector3d::Zero()}};
  m.bodies[1].compliance->by_load = Eigen::MatrixXd::Zero(12, 6);
  EXPECT_TRUE(simulate(m, settings).unshared.loaded.empty());
  m.bodies[1].compliance.reset();
  EXPECT_TRUE(simulate(m, settings).unshared.loaded.empty());
}

}  // namespace
}  // namespace clevis::mechanism
