// A pin in a slot: the same as a revolute on a block without mass that slides.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "mechanism/simulate.h"
#include "support/free_linkages.h"
#include "support/landing_gear.h"

namespace clevis::mechanism {
namespace {

using namespace testing;

constexpr double kCrank = 0.05, kDepth = 0.12;  // m
constexpr double kPinMass = 1e-12;              // kg

enum class Slot { kPointOnLine, kBlock };

BodyDefinition block(const Vector3d& at) {
  BodyDefinition body = uniform_bar("block", at, 0.0, 0.01);
  body.mass_properties.mass = kPinMass;
  body.mass_properties.p_LCm.setZero();
  body.mass_properties.inertia_LCm = 1e-5 * kPinMass * Matrix3d::Identity();
  return body;
}

JointDefinition joint(const std::string& name, JointType type, int a, int b,
                      const JointFrame& frame_a, const JointFrame& frame_b) {
  JointDefinition result;
  result.name = name;
  result.type = type;
  result.body_a = a;
  result.body_b = b;
  result.frame_a = frame_a;
  result.frame_b = frame_b;
  result.place = "joint " + name;
  return result;
}

/// Quick return: a crank about the origin, its pin in the slot along x of a
/// rocker that turns about a point below.
MechanismDefinition quick_return(Slot slot) {
  MechanismDefinition m;
  m.dimension = SpaceDimension::kPlanar;
  m.gravity_W = {0.0, -9.81, 0.0};
  const Vector3d pin_W(kCrank, 0.0, 0.0), pivot_W(0.0, -kDepth, 0.0);
  const double lean = std::atan2(kDepth, kCrank);
  m.bodies = {uniform_bar("crank", Vector3d::Zero(), 0.0, kCrank),
              uniform_bar("rocker", pivot_W, lean, 0.2)};
  m.joints = {pin("A", kGround, 0, 0.0, 0.0),
              pin("B", kGround, 1, 0.0, 0.0, -kDepth)};
  const JointFrame line{.p_LJ = Vector3d::Zero(), .R_LJ = slide(1.0).R_LJ};
  if (slot == Slot::kPointOnLine) {
    m.joints.push_back(joint("P", JointType::kPointOnLine, 1, 0, line,
                             {.p_LJ = pin_W, .R_LJ = slide(1.0).R_LJ}));
  } else {
    BodyDefinition slider = block(pin_W);
    slider.placement.R_WL = m.bodies[1].placement.R_WL;
    m.bodies.push_back(slider);
    m.joints.push_back(
        joint("P", JointType::kRevolute, 2, 0, {}, {.p_LJ = pin_W}));
    m.joints.push_back(
        joint("S", JointType::kPrismatic, 1, 2, line,
              {.p_LJ = Vector3d::Zero(), .R_LJ = slide(1.0).R_LJ}));
  }
  return m;
}

void drive_crank(MechanismDefinition& m) {
  DriveDefinition drive;
  drive.joint = 0;
  drive.law = DriveLaw::kSpeed;
  drive.speed = 8.0;
  drive.place = "drive";
  m.drives = {drive};
}

SimulationSettings settings(MotionKind kind) {
  SimulationSettings s;
  s.duration = 1.0;
  s.instants = 41;
  s.tolerance = 1e-11;
  s.motion = kind;
  return s;
}

/// Motions and reactions agree; the force on the pin too.
void expect_alike(const Motion& one, const Motion& other, double close) {
  ASSERT_EQ(one.instants.size(), other.instants.size());
  for (std::size_t i = 0; i < one.instants.size(); ++i) {
    const Instant& a = one.instants[i];
    const Instant& b = other.instants[i];
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_LT((a.bodies[k].pose.R_WL - b.bodies[k].pose.R_WL).norm(), close)
          << a.t;
      EXPECT_LT((a.bodies[k].alpha_WL - b.bodies[k].alpha_WL).norm(),
                1e3 * close)
          << a.t;
    }
    for (std::size_t j = 0; j < 3; ++j) {
      EXPECT_LT((a.joints[j].f_W - b.joints[j].f_W).norm(), 1e2 * close)
          << a.t << ' ' << j;
    }
    EXPECT_LT(a.joints[2].t_W.norm(), close);
  }
}

TEST(PointOnLine, IsAPinInASlotOfThePlane) {
  MechanismDefinition direct = quick_return(Slot::kPointOnLine);
  MechanismDefinition with_block = quick_return(Slot::kBlock);
  drive_crank(direct);
  drive_crank(with_block);
  const Motion motion = simulate(direct, settings(MotionKind::kDriven));
  for (const Instant& i : motion.instants) {
    const double turn = 8.0 * i.t;
    const double lean =
        std::atan2(kDepth + kCrank * std::sin(turn), kCrank * std::cos(turn));
    const Matrix3d& R = i.bodies[1].pose.R_WL;
    EXPECT_NEAR(R(0, 0), std::cos(lean), 1e-10);
    EXPECT_NEAR(R(1, 0), std::sin(lean), 1e-10);
    // the slot pushes across itself only
    EXPECT_NEAR(i.joints[2].f_W.dot(R.col(0)), 0.0, 1e-9);
    EXPECT_GT(i.joints[2].f_W.norm(), 1e-3);
  }
  expect_alike(motion, simulate(with_block, settings(MotionKind::kDriven)),
               1e-9);
}

TEST(PointOnLine, SwingsLikeThePinInItsBlock) {
  expect_alike(
      simulate(quick_return(Slot::kPointOnLine),
               settings(MotionKind::kDynamic)),
      simulate(quick_return(Slot::kBlock), settings(MotionKind::kDynamic)),
      1e-7);
}

/// A bar whose end slides and turns freely on a line that leans in space.
MechanismDefinition hanging_bar(Slot slot) {
  MechanismDefinition m;
  m.dimension = SpaceDimension::kSpatial;
  m.gravity_W = {1.0, -9.81, 2.0};
  BodyDefinition bar = uniform_bar("bar", {0.02, 0.0, 0.0}, 0.4, 0.1);
  bar.mass_properties.inertia_LCm.diagonal() = Vector3d(2e-4, 9e-4, 1e-3);
  m.bodies = {bar};
  const Matrix3d lean =
      Eigen::AngleAxisd(0.3, Vector3d(0.6, 0.0, 0.8)).toRotationMatrix();
  const JointFrame line{.p_LJ = lean * Vector3d(0.02, 0.0, 0.0),
                        .R_LJ = lean * slide(1.0).R_LJ};
  m.bodies[0].placement.p_WL = line.p_LJ;
  if (slot == Slot::kPointOnLine) {
    m.joints = {joint("P", JointType::kPointOnLine, kGround, 0, line, {})};
  } else {
    BodyDefinition slider = block(line.p_LJ);
    slider.placement.R_WL = lean;
    m.bodies.push_back(slider);
    m.joints = {joint("P", JointType::kSpherical, 1, 0, {}, {}),
                joint("S", JointType::kPrismatic, kGround, 1, line,
                      {.p_LJ = Vector3d::Zero(), .R_LJ = slide(1.0).R_LJ})};
  }
  return m;
}

TEST(PointOnLine, IsABallInATubeOfSpace) {
  const Motion direct =
      simulate(hanging_bar(Slot::kPointOnLine), settings(MotionKind::kDynamic));
  const Motion other =
      simulate(hanging_bar(Slot::kBlock), settings(MotionKind::kDynamic));
  double moved = 0.0;
  for (std::size_t i = 0; i < direct.instants.size(); ++i) {
    const Instant& a = direct.instants[i];
    const Instant& b = other.instants[i];
    EXPECT_LT((a.bodies[0].pose.p_WL - b.bodies[0].pose.p_WL).norm(), 1e-6);
    EXPECT_LT((a.joints[0].f_W - b.joints[0].f_W).norm(),
              1e-5 * (1.0 + b.joints[0].f_W.norm()))
        << a.t;
    moved = std::max(
        moved, (a.bodies[0].pose.p_WL - direct.instants[0].bodies[0].pose.p_WL)
                   .norm());
  }
  EXPECT_GT(moved, 0.1);
}

}  // namespace
}  // namespace clevis::mechanism
