// Newton–Euler balance of every body, recomputed here from what is printed:
// poses, accelerations, reactions in W.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "mechanism/simulate.h"
#include "support/four_bar.h"
#include "support/free_linkages.h"
#include "support/newton_euler.h"

namespace clevis::mechanism {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using namespace testing;

double largest_imbalance(const MechanismDefinition& m, double duration) {
  const Motion motion = simulate(m, {.duration = duration, .instants = 41});
  double worst = 0.0;
  for (const Instant& at : motion.instants) {
    worst = std::max(worst, imbalance(m, at));
  }
  return worst;
}

MechanismDefinition fast_and_loaded() {
  MechanismDefinition m = landing_gear();
  m.drives[0].duration = 0.05;
  m.elements = {wheel_load(0.14)};
  std::get<ConstantForce>(m.elements[0]).t_W = {0.0, 0.0, 7.0};
  return m;
}

constexpr double kRoundOff = 1e-11;  // condition number times ε

TEST(Dynamics, EveryBodyOfTheLandingGearIsInBalance) {
  EXPECT_LT(largest_imbalance(fast_and_loaded(), 0.05), kRoundOff);
}

TEST(Dynamics, EveryBodyIsInBalanceTakenAsSpatial) {
  MechanismDefinition m = fast_and_loaded();
  m.dimension = SpaceDimension::kSpatial;
  EXPECT_LT(largest_imbalance(m, 0.05), kRoundOff);
}

// Mass and load beside the plane, products of inertia, gravity across it: a
// planar mechanism's parts still carry all of it.
TEST(Dynamics, LoadsAcrossThePlaneAreCarried) {
  MechanismDefinition m = fast_and_loaded();
  m.gravity_W = {1.0, -9.0, 3.0};
  m.bodies[kBodyDCE].mass_properties.p_LCm.z() = 0.004;
  m.bodies[kBodyDCE].mass_properties.inertia_LCm(0, 2) = 3e-5;
  m.bodies[kBodyDCE].mass_properties.inertia_LCm(2, 0) = 3e-5;
  std::get<ConstantForce>(m.elements[0]).point.p_L.z() = 0.01;
  std::get<ConstantForce>(m.elements[0]).t_W = {1.0, 2.0, 3.0};
  EXPECT_LT(largest_imbalance(m, 0.05), kRoundOff);
  const Instant at = simulate(m, {.duration = 0.05}).instants[100];
  EXPECT_FALSE(at.joints[kD].unique);
  EXPECT_TRUE(at.joints[kD].unique_components[0]);
  EXPECT_TRUE(at.joints[kD].unique_components[1]);
  EXPECT_FALSE(at.joints[kD].unique_components[2]);
}

// Links beside one another along the pins: levers across the plane, also of
// the drive's force.
TEST(Dynamics, LinksBesideOneAnother) {
  MechanismDefinition m = fast_and_loaded();
  for (JointDefinition& joint : m.joints) {
    if (joint.body_a == kBodyBC) joint.frame_a.p_LJ.z() += 0.006;
    if (joint.body_b == kBodyBC) joint.frame_b.p_LJ.z() += 0.006;
    if (joint.body_a == kFE1) joint.frame_a.p_LJ.z() -= 0.004;
    if (joint.body_b == kFE1) joint.frame_b.p_LJ.z() += 0.004;
    if (joint.body_b == kFE2 && joint.name == "E") {
      joint.frame_b.p_LJ.z() += 0.007;
    }
  }
  // FE1's joints: F at +4 mm, cylinder at −4 mm of it; FE2 follows, and E
  // closes the loop along z
  m.joints[kE].frame_a.p_LJ.z() = -0.004 - 0.004 + 0.007;
  EXPECT_LT(largest_imbalance(m, 0.05), kRoundOff);
}

TEST(Dynamics, PlanarAndSpatialAgreeInWhatIsUnique) {
  MechanismDefinition m = fast_and_loaded();
  const Motion planar = simulate(m, {.duration = 0.05, .instants = 21});
  m.dimension = SpaceDimension::kSpatial;
  const Motion spatial = simulate(m, {.duration = 0.05, .instants = 21});
  for (std::size_t i = 0; i < planar.instants.size(); ++i) {
    const Instant& p = planar.instants[i];
    const Instant& s = spatial.instants[i];
    double scale = 0.0;
    for (const JointReaction& r : p.joints) {
      scale = std::max(scale, r.f_W.norm());
    }
    for (std::size_t j = 0; j < p.joints.size(); ++j) {
      const JointReaction& r = s.joints[j];
      EXPECT_LT((p.joints[j].f_W - r.f_W).head<2>().norm(), 1e-10 * scale);
      EXPECT_NEAR(p.joints[j].t_W.z(), r.t_W.z(), 1e-10 * scale);
      if (m.joints[j].type != JointType::kRevolute) continue;
      EXPECT_TRUE(r.unique_components[0]);
      EXPECT_TRUE(r.unique_components[1]);
      // Open by rank, but nothing loads them: that decides nothing.
      EXPECT_LT(std::abs(r.f_W.z()), 1e-6 * scale);
      EXPECT_TRUE(r.unique_components[2]);
      EXPECT_TRUE(r.unique_components[3]);
    }
    EXPECT_NEAR(p.drives[0].effort, s.drives[0].effort, 1e-10 * scale);
    for (std::size_t b = 0; b < p.bodies.size(); ++b) {
      EXPECT_LT((p.bodies[b].a_WLo - s.bodies[b].a_WLo).norm(),
                1e-10 * (1.0 + p.bodies[b].a_WLo.norm()));
    }
  }
}

// A spatial mechanism of its own: a bar on a turntable, hinged across, both
// driven. Gyroscopic moments count.
TEST(Dynamics, TurntableWithAHingedBar) {
  MechanismDefinition m;
  m.bodies.resize(2);
  m.bodies[0].name = "table";
  m.bodies[0].mass_properties = bar(1.0, 0.02, 0.0, 2e-3);
  m.bodies[1].name = "bar";
  m.bodies[1].placement.p_WL = {0.1, 0.0, 0.0};
  m.bodies[1].mass_properties = bar(0.5, 0.08, 0.01, 1e-3);
  Matrix3d across;  // z along y of the table
  across << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  JointDefinition spindle;
  spindle.name = "spindle";
  spindle.type = JointType::kRevolute;
  spindle.body_b = 0;
  JointDefinition hinge = spindle;
  hinge.name = "hinge";
  hinge.body_a = 0;
  hinge.body_b = 1;
  hinge.frame_a = {{0.1, 0.0, 0.0}, across};
  hinge.frame_b = {Vector3d::Zero(), across};
  m.joints = {spindle, hinge};
  m.drives.resize(2);
  m.drives[0].joint = 0;
  m.drives[0].law = DriveLaw::kQuintic;
  m.drives[0].to = 5.0;
  m.drives[0].duration = 0.4;
  m.drives[1].joint = 1;
  m.drives[1].law = DriveLaw::kSine;
  m.drives[1].amplitude = 0.8;
  m.drives[1].frequency = 3.0;
  m.gravity_W = {0.0, 0.0, -9.81};
  EXPECT_LT(largest_imbalance(m, 0.4), kRoundOff);
  for (const Instant& at :
       simulate(m, {.duration = 0.4, .instants = 41}).instants) {
    EXPECT_LT(at.power_balance_error, 1e-12);
    EXPECT_TRUE(at.joints[0].unique && at.joints[1].unique);
    // the spindle turns all, by its own angle
    EXPECT_NEAR(at.bodies[0].w_WL.z(), at.drives[0].rate, 1e-12);
    EXPECT_NEAR(at.bodies[1].w_WL.z(), at.drives[0].rate, 1e-11);
  }
}

// Two free bars on one pin, the first pushed across: it has the rates that are
// given, the second those of a bar that is struck at its end, v/4 and 3v/2l.
TEST(Dynamics, GivenBodiesStartAsGiven) {
  MechanismDefinition m;
  m.bodies = {uniform_bar("first", Vector3d::Zero(), 0.0, 1.0),
              uniform_bar("second", {1.0, 0.0, 0.0}, 0.0, 1.0)};
  m.bodies[1].mass_properties.mass *= 4.0;
  m.bodies[1].mass_properties.inertia_LCm *= 4.0;
  m.joints = {pin("A", 0, 1, 1.0, 0.0)};
  m.gravity_W.setZero();
  m.initial_bodies = {{.body = 0,
                       .v_WLo = {0.0, 1.0, 0.0},
                       .w_WL = Vector3d::Zero(),
                       .place = "initial"}};
  const Motion motion = simulate(m, {.duration = 0.1, .instants = 3});
  const Instant& start = motion.instants.front();
  EXPECT_NEAR(start.bodies[0].v_WLo.y(), 1.0, 1e-9);
  EXPECT_NEAR(start.bodies[0].w_WL.z(), 0.0, 1e-9);
  EXPECT_NEAR(start.bodies[1].w_WL.z(), -1.5, 1e-6);
}

}  // namespace
}  // namespace clevis::mechanism
