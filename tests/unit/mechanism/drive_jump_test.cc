// Drives that change their speed in no time: an impulse that conserves what it
// cannot reach.
#include <cmath>

#include <gtest/gtest.h>

#include "mechanism/simulate.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

using Eigen::Vector3d;

constexpr double kW = 2.0, kLength = 1.0, kC = 0.5, kMass = 3.0;
constexpr double kAboutPin = kMass / 3.0;  // of a uniform bar of 1 m

/// A driven bar of 1 m with another one hinged to its end, without gravity.
/// The drive turns by kW from 0.5 s to 1.5 s.
MechanismDefinition double_bar() {
  MechanismDefinition m;
  m.bodies = {testing::uniform_bar("a", Vector3d::Zero(), 0.0, 1.0),
              testing::uniform_bar("b", {1.0, 0.0, 0.0}, 0.4, 1.0)};
  for (BodyDefinition& body : m.bodies) {
    body.mass_properties.mass = kMass;
    body.mass_properties.p_LCm = {kC, 0.0, 0.0};
    body.mass_properties.inertia_LCm =
        kMass / 12.0 * Eigen::Matrix3d::Identity();
  }
  m.joints = {testing::pin("A", kGround, 0, 0.0, 0.0),
              testing::pin("B", 0, 1, kLength, 0.0)};
  DriveDefinition drive;
  drive.joint = 0;
  drive.law = DriveLaw::kRamp;
  drive.start = 0.5;
  drive.duration = 1.0;
  drive.to = kW;
  m.drives = {drive};
  return m;
}

double turned(const Instant& at, std::size_t body) {
  const Eigen::Matrix3d& R = at.bodies[body].pose.R_WL;
  return std::atan2(R(1, 0), R(0, 0));
}

/// Angle and speed of b against a.
struct Relative {
  double angle, rate;
};

Relative relative(const Instant& at) {
  return {turned(at, 1) - turned(at, 0),
          at.bodies[1].w_WL.z() - at.bodies[0].w_WL.z()};
}

TEST(DriveJump, ImpulseOnAHingedBar) {
  SimulationSettings s;
  s.duration = 2.0;
  s.instants = 401;
  s.tolerance = 1e-9;
  const MechanismDefinition m = double_bar();
  const Motion motion = simulate(m, s);
  ASSERT_TRUE(motion.integration);
  EXPECT_LT(motion.integration->relative_energy_error, 1e-9);
  const auto& instants = motion.instants;
  // angular momentum of b about its pin stays: the pin's speed jumps
  const double taken = kMass * kC * kLength * kW / kAboutPin;
  const double after = -taken * std::cos(0.4);
  EXPECT_NEAR(instants[99].bodies[1].w_WL.z(), 0.0, 1e-12);
  EXPECT_NEAR(relative(instants[101]).rate, after - kW, 0.05);
  // a pendulum in the centrifugal field of a: an energy that stays
  const double field = taken * kW;
  const auto energy = [&](const Relative& r) {
    return 0.5 * r.rate * r.rate - field * std::cos(r.angle);
  };
  const double start = energy({0.4, after - kW});
  for (std::size_t i = 101; i < 300; ++i) {
    EXPECT_NEAR(energy(relative(instants[i])), start, 1e-7);
  }
  // at the end of the stroke, and at rest from then on
  const Relative last = relative(instants[300]);
  const double angle_b = turned(instants[300], 1);
  const double end = last.rate + kW + taken * std::cos(angle_b - kW);
  for (std::size_t i = 301; i < 401; ++i) {
    EXPECT_NEAR(instants[i].bodies[1].w_WL.z(), end, 1e-7);
    EXPECT_NEAR(instants[i].bodies[0].w_WL.z(), 0.0, 1e-12);
  }
  ASSERT_EQ(motion.drive_jumps.size(), 2u);
  EXPECT_EQ(motion.drive_jumps[0].t, 0.5);
  EXPECT_EQ(motion.drive_jumps[0].before, 0.0);
  EXPECT_EQ(motion.drive_jumps[0].behind, kW);
  EXPECT_EQ(motion.drive_jumps[1].before, kW);
}

TEST(DriveJump, OnlyLawsThatJumpInsideTheMotion) {
  SimulationSettings s;
  s.duration = 1.0;
  s.instants = 11;
  MechanismDefinition m = double_bar();
  m.bodies.pop_back();
  m.joints.pop_back();
  DriveDefinition& drive = m.drives[0];
  drive.law = DriveLaw::kQuintic;
  EXPECT_TRUE(simulate(m, s).drive_jumps.empty());
  drive.law = DriveLaw::kRamp;
  drive.start = 0.0;  // moves from the start to the end
  EXPECT_TRUE(simulate(m, s).drive_jumps.empty());
  drive.duration = 0.75;
  ASSERT_EQ(simulate(m, s).drive_jumps.size(), 1u);
  drive.law = DriveLaw::kSine;
  drive.amplitude = 0.1;
  drive.frequency = 1.0;
  EXPECT_TRUE(simulate(m, s).drive_jumps.empty());
  drive.start = 0.25;
  EXPECT_NEAR(simulate(m, s).drive_jumps.at(0).behind, 0.2 * M_PI, 1e-12);
  drive.law = DriveLaw::kTable;
  for (const auto ends :
       {numerics::SplineEnds::kClamped, numerics::SplineEnds::kNatural}) {
    drive.table =
        numerics::interpolating_spline({0.0, 0.2, 0.5}, {0.0, 0.3, 0.1}, ends);
    EXPECT_EQ(simulate(m, s).drive_jumps.size(),
              ends == numerics::SplineEnds::kClamped ? 0u : 2u);
  }
}

// A slide at rest by its friction is struck and slips; friction has no part in
// the impulse.
TEST(DriveJump, ElementsAtRestLetsGo) {
  MechanismDefinition m = double_bar();
  FrictionLaw law;
  law.kinetic = law.breakaway = 0.5;
  m.elements = {testing::on_joint(1, law)};
  SimulationSettings s;
  s.duration = 0.502;
  s.instants = 252;
  s.tolerance = 1e-9;
  const Motion motion = simulate(m, s);
  const double after =
      -kMass * kC * kLength * kW / kAboutPin * std::cos(0.4) - kW;
  EXPECT_NEAR(relative(motion.instants.back()).rate, after, 0.02);
  EXPECT_LT(motion.integration->relative_energy_error, 1e-8);
}

// A drive that moves from the start on strikes what hangs on it at rest, as one
// that jumps does; how far it goes later is no matter.
TEST(DriveJump, StartAtSpeedIsAnImpulseToo) {
  for (const double stroke : {0.2, 7.0}) {
    MechanismDefinition m = double_bar();
    m.drives[0].start = 0.0;
    m.drives[0].to = stroke * kW;
    m.drives[0].duration = stroke;
    SimulationSettings s;
    s.duration = 0.1;
    s.instants = 3;
    s.tolerance = 1e-9;
    const Motion motion = simulate(m, s);
    EXPECT_NEAR(motion.instants[0].bodies[1].w_WL.z(),
                -kMass * kC * kLength * kW / kAboutPin * std::cos(0.4), 1e-12);
  }
}

// A rack that its drive carries on by more than half a turn in one step.
TEST(DriveJump, RackCountsItsTurnsInLongSteps) {
  MechanismDefinition m = testing::sliders({1.0});
  m.bodies.push_back(testing::uniform_bar("wheel", {0.0, 0.5, 0.0}, 0.0, 0.1));
  m.joints.push_back(testing::pin("W", kGround, 1, 0.0, 0.5));
  m.couplings.push_back({.name = "rack",
                         .joint_1 = 0,
                         .joint_2 = 1,
                         .ratio = 0.05,
                         .offset = 0.0,
                         .place = "rack"});
  DriveDefinition drive;
  drive.joint = 0;
  drive.law = DriveLaw::kQuintic;
  drive.start = 0.2;
  drive.duration = 0.1;
  drive.to = -0.5;  // ten radians of the wheel
  m.drives = {drive};
  SimulationSettings s;
  s.motion = MotionKind::kDynamic;
  s.duration = 1.0;
  s.instants = 51;
  s.tolerance = 1e-8;
  const Motion motion = simulate(m, s);
  for (const Instant& at : motion.instants) {
    EXPECT_LT(at.closure_error, 1e-9) << at.t;
  }
}

}  // namespace
}  // namespace clevis::mechanism
