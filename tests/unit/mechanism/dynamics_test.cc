// Newton–Euler balance of every body, recomputed here from what is printed:
// poses, accelerations, reactions in W.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "mechanism/simulate.h"
#include "support/four_bar.h"

namespace clevis::mechanism {
namespace {

using Eigen::Matrix3d;
using namespace testing;

struct Balance {
  Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();  // about Cm
  double scale = 0.0;

  void add(const Vector3d& f, const Vector3d& lever, const Vector3d& t) {
    force += f;
    moment += lever.cross(f) + t;
    scale = std::max({scale, f.norm(), t.norm() / 0.1});
  }
};

/// Largest residual over its body's largest force.
double imbalance(const MechanismDefinition& m, const Instant& at) {
  double worst = 0.0;
  for (std::size_t i = 0; i < m.bodies.size(); ++i) {
    const auto& mass = m.bodies[i].mass_properties;
    const BodyState& body = at.bodies[i];
    const Matrix3d& R = body.pose.R_WL;
    const Vector3d c = R * mass.p_LCm;
    const Vector3d p_WCm = body.pose.p_WL + c;
    const Vector3d& w = body.w_WL;
    Balance sum;
    sum.add(mass.mass * m.gravity_W, Vector3d::Zero(), Vector3d::Zero());
    const Vector3d a_Cm =
        body.a_WLo + body.alpha_WL.cross(c) + w.cross(Vector3d(w.cross(c)));
    const Matrix3d inertia = R * mass.inertia_LCm * R.transpose();
    sum.add(-mass.mass * a_Cm, Vector3d::Zero(),
            -(inertia * body.alpha_WL + w.cross(Vector3d(inertia * w))));
    for (std::size_t j = 0; j < m.joints.size(); ++j) {
      const JointReaction& r = at.joints[j];
      const Vector3d lever = r.p_WJ - p_WCm;
      const auto self = static_cast<int>(i);
      if (m.joints[j].body_b == self) sum.add(r.f_W, lever, r.t_W);
      if (m.joints[j].body_a == self) sum.add(-r.f_W, lever, -r.t_W);
    }
    for (std::size_t k = 0; k < m.drives.size(); ++k) {
      const auto j = static_cast<std::size_t>(m.drives[k].joint);
      const bool slides = m.joints[j].type == JointType::kPrismatic;
      const Vector3d e = at.drives[k].effort * at.drives[k].axis_W;
      const Vector3d f = slides ? e : Vector3d::Zero();
      const Vector3d t = slides ? Vector3d::Zero() : e;
      const Vector3d lever = at.joints[j].p_WJ - p_WCm;
      const auto self = static_cast<int>(i);
      if (m.joints[j].body_b == self) sum.add(f, lever, t);
      if (m.joints[j].body_a == self) sum.add(-f, lever, -t);
    }
    for (const ForceDefinition& force : m.forces) {
      if (force.body != static_cast<int>(i)) continue;
      sum.add(force.f_W, R * (force.p_LP - mass.p_LCm), force.t_W);
    }
    worst = std::max({worst, sum.force.norm() / sum.scale,
                      sum.moment.norm() / (0.1 * sum.scale)});
  }
  return worst;
}

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
  m.forces = {wheel_load(0.14)};
  m.forces[0].t_W = {0.0, 0.0, 7.0};
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
  m.forces[0].p_LP.z() = 0.01;
  m.forces[0].t_W = {1.0, 2.0, 3.0};
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
      EXPECT_FALSE(r.unique_components[2]);
      EXPECT_FALSE(r.unique_components[3]);
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

}  // namespace
}  // namespace clevis::mechanism
