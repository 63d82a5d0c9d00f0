#include "machine/bearings/bearing_history.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "machine/bearings/bearing_life.h"
#include "mechanism/simulate.h"
#include "part/verdict.h"
#include "support/landing_gear.h"

namespace clevis::machine {
namespace {

using namespace mechanism::testing;
using Eigen::Vector3d;
using mechanism::MechanismDefinition;

BearingDefinition bearing_in(int joint) {
  BearingDefinition bearing;
  bearing.name = "bearing";
  bearing.joint = joint;
  bearing.dynamic_rating = 1470.0;
  bearing.static_rating = 550.0;
  return bearing;
}

/// The wheel's load at pin C, without inertia and weight.
MechanismDefinition loaded_at_C() {
  MechanismDefinition m = landing_gear();
  m.gravity_W.setZero();
  m.drives[0].duration = 2000.0;
  m.elements = {wheel_load(0.0)};
  return m;
}

// AB is then idle and C carries |(500, 1000)| N everywhere.
TEST(BearingHistory, PinOfTheLandingGearCarriesTheWheelLoad) {
  const MechanismDefinition m = loaded_at_C();
  const auto motion = simulate(m, {.duration = 2000.0, .instants = 101});
  for (const auto& here : bearing_history(bearing_in(kC), m, motion)) {
    EXPECT_NEAR(here.radial, std::hypot(500.0, 1000.0), 1e-5);
    EXPECT_EQ(here.axial, 0.0);
    EXPECT_TRUE(here.unique);
  }
  const auto results = judge_bearings({bearing_in(kC)}, m, motion);
  EXPECT_NEAR(*results[0].life, 2.273e6, 0.001e6);
  // DCE turns by 113.34 degrees over the stroke, BC not at all
  EXPECT_NEAR(results[0].swing * 180.0 / std::numbers::pi, 113.34, 0.005);
  EXPECT_NEAR(results[0].travel, results[0].swing, 1e-9);
}

// The loads are those of the joint, wherever its mechanism stands.
TEST(BearingHistory, DoesNotDependOnTheFrameOfTheWorld) {
  const MechanismDefinition m = loaded_at_C();
  const Eigen::Matrix3d R =
      Eigen::AngleAxisd(1.1, Vector3d(1.0, 2.0, -0.5).normalized())
          .toRotationMatrix();
  const MechanismDefinition there = moved(m, R, {0.3, -2.0, 1.0});
  const mechanism::SimulationSettings settings{.duration = 2000.0,
                                               .instants = 21};
  const auto here = simulate(m, settings), other = simulate(there, settings);
  for (const int joint : {kC, kD, kE, kF}) {
    const auto one = judge_bearings({bearing_in(joint)}, m, here);
    const auto two = judge_bearings({bearing_in(joint)}, there, other);
    EXPECT_NEAR(two[0].mean_load / one[0].mean_load, 1.0, 1e-8);
    EXPECT_NEAR(*two[0].life_cycles / *one[0].life_cycles, 1.0, 1e-7);
    EXPECT_LT(two[0].peak_axial, 1e-8 * one[0].peak_radial);
  }
}

/// A flywheel on an axis that leans by 0.3 rad from the vertical towards x,
/// balanced, driven at 5 rad/s, its centre `height` along the axis from the
/// joint.
MechanismDefinition flywheel(double height) {
  MechanismDefinition m;
  mechanism::BodyDefinition wheel;
  wheel.name = "wheel";
  wheel.mass_properties.mass = 2.0;
  wheel.mass_properties.p_LCm = {0.0, 0.0, height};
  wheel.mass_properties.inertia_LCm = Vector3d(1e-3, 1e-3, 2e-3).asDiagonal();
  const Eigen::Matrix3d R =
      Eigen::AngleAxisd(0.3, Vector3d::UnitY()).toRotationMatrix();
  wheel.placement.R_WL = R;
  m.bodies = {wheel};
  mechanism::JointDefinition joint;
  joint.name = "hub";
  joint.body_b = 0;
  joint.frame_a.R_LJ = R;
  m.joints = {joint};
  mechanism::DriveDefinition drive;
  drive.law = mechanism::DriveLaw::kRamp;
  drive.to = 5.0;
  drive.duration = 1.0;
  m.drives = {drive};
  m.gravity_W = {0.0, 0.0, -9.81};
  m.dimension = mechanism::SpaceDimension::kSpatial;
  return m;
}

TEST(BearingHistory, WeightSplitsAlongAndAcrossALeaningAxis) {
  const double height = 0.05, weight = 2.0 * 9.81;
  const MechanismDefinition m = flywheel(height);
  const auto motion = simulate(m, {.duration = 1.0, .instants = 11});
  const auto history = bearing_history(bearing_in(0), m, motion);
  for (std::size_t i = 1; i + 1 < history.size(); ++i) {
    EXPECT_NEAR(history[i].axial, weight * std::cos(0.3), 1e-9);
    EXPECT_NEAR(history[i].radial, weight * std::sin(0.3), 1e-9);
    EXPECT_NEAR(history[i].tilt, height * weight * std::sin(0.3), 1e-9);
    EXPECT_NEAR(history[i].speed, 5.0, 1e-9);
  }
}

// A wheel on the ground and a pinion in a housing that turns on the ground: the
// teeth load the housing's bearing, too.
TEST(BearingHistory, BearingThatTeethLoadCannotPass) {
  MechanismDefinition m = flywheel(0.0);
  m.bodies.resize(3, m.bodies[0]);
  m.joints.resize(3, m.joints[0]);
  m.drives.resize(3, m.drives[0]);
  m.joints[1].body_b = 1;
  m.joints[2].body_a = 1;
  m.joints[2].body_b = 2;
  m.joints[2].frame_a = m.joints[2].frame_b;
  m.drives[1].joint = 1;
  m.drives[2].joint = 2;
  const auto motion = simulate(m, {.duration = 1.0, .instants = 11});
  const auto judged = [&](int joint) {
    BearingDefinition bearing = bearing_in(joint);
    bearing.dynamic_factors = AxialFactors{1.0, 1.0, 0.0};
    bearing.static_factors = AxialFactors{1.0, 1.0, 0.0};
    return judge_bearings({bearing}, m, motion)[0].verdict;
  };
  for (const int joint : {0, 1, 2}) {
    EXPECT_EQ(judged(joint), part::Verdict::kPass) << joint;
  }
  m.couplings.push_back({.joint_1 = 0, .joint_2 = 1});
  for (const int joint : {0, 1}) {
    EXPECT_EQ(judged(joint), part::Verdict::kNotJudged) << joint;
  }
  EXPECT_EQ(judged(2), part::Verdict::kPass);
  m.couplings[0].joint_2 = 2;
  for (const int joint : {0, 1, 2}) {
    EXPECT_EQ(judged(joint), part::Verdict::kNotJudged) << joint;
  }
}

}  // namespace
}  // namespace clevis::machine
