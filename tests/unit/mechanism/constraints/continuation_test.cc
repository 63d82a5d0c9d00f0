#include "mechanism/constraints/continuation.h"

#include <cmath>

#include <gtest/gtest.h>

#include "mechanism/constraints/closed_joints.h"
#include "support/free_linkages.h"
#include "support/landing_gear.h"

namespace clevis::mechanism {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kCrank = 0.1, kRod = 0.3;  // m

/// Slider-crank along x; its slider or its crank is driven.
MechanismDefinition slider_crank(int driven) {
  MechanismDefinition m;
  m.dimension = SpaceDimension::kPlanar;
  const double turn = 0.9;
  const double x =
      kCrank * std::cos(turn) +
      std::sqrt(kRod * kRod - std::pow(kCrank * std::sin(turn), 2));
  const Vector3d pin_W(kCrank * std::cos(turn), kCrank * std::sin(turn), 0.0);
  const double lean = -std::asin(kCrank * std::sin(turn) / kRod);
  m.bodies = {testing::uniform_bar("crank", {0.0, 0.0, 0.0}, turn, kCrank),
              testing::uniform_bar("rod", pin_W, lean, kRod),
              testing::uniform_bar("slider", {x, 0.0, 0.0}, 0.0, 0.05)};
  m.joints = {testing::pin("A", kGround, 0, 0.0, 0.0),
              testing::pin("B", 0, 1, kCrank, 0.0),
              testing::pin("C", 1, 2, kRod, 0.0),
              {.name = "S",
               .type = JointType::kPrismatic,
               .body_a = kGround,
               .body_b = 2,
               .frame_a = testing::slide(1.0),
               .frame_b = testing::slide(1.0),
               .place = "joint S"}};
  DriveDefinition drive;
  drive.joint = driven;
  m.drives = {drive};
  return m;
}

/// Follows the drive from the placement to a coordinate.
struct Followed {
  Followed(int driven, double from, double to)
      : definition(slider_crank(driven)),
        frame(definition),
        system(frame, definition.drives, Motions::kInPlane,
               ConstraintSystem::Drives::kAll),
        continuation(system, 1e-12) {
    const auto start = continuation.close(
        closed_joints(definition, frame, 1e-12), VectorXd::Constant(1, from));
    reached = continuation.follow(start, VectorXd::Constant(1, to));
  }

  MechanismDefinition definition;
  SolvingFrame frame;
  ConstraintSystem system;
  Continuation continuation;
  Continuation::Reached reached;
};

double angle_of(const BodyPlacement& body) {
  return std::atan2(body.R(1, 0), body.R(0, 0));
}

double slider_at(double turn) {
  return kCrank * std::cos(turn) +
         std::sqrt(kRod * kRod - std::pow(kCrank * std::sin(turn), 2));
}

TEST(Continuation, FollowsTheDriveOnItsBranch) {
  const Followed crank(0, 0.9, 2.8);
  EXPECT_EQ(crank.reached.part, 1.0);
  EXPECT_LT(crank.reached.at.gap, 1e-12);
  EXPECT_NEAR(angle_of(crank.reached.at.x[1]), 2.8, 1e-11);
  const double lean = -std::asin(kCrank * std::sin(2.8) / kRod);
  EXPECT_NEAR(angle_of(crank.reached.at.x[2]), lean, 1e-11);
  // the other way round: the slider's place tells the crank's angle
  const Followed slider(3, slider_at(0.9), slider_at(1.7));
  EXPECT_EQ(slider.reached.part, 1.0);
  EXPECT_NEAR(angle_of(slider.reached.at.x[1]), 1.7, 1e-10);
}

// Past the dead centre there is nothing to follow to.
TEST(Continuation, StopsWhereTheMechanismCannotReach) {
  const double from = slider_at(0.9), dead = kCrank + kRod;
  const Followed beyond(3, from, dead + 0.01);
  EXPECT_LT(beyond.reached.part, 1.0);
  const double there = from + beyond.reached.part * (dead + 0.01 - from);
  EXPECT_LE(there, dead + 1e-9);
  EXPECT_GT(there, dead - 1e-4);
  EXPECT_LT(beyond.reached.at.gap, 1e-12);
}

}  // namespace
}  // namespace clevis::mechanism
