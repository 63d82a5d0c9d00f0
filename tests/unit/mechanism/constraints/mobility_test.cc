#include "mechanism/constraints/mobility.h"

#include <string>

#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "mechanism/constraints/closed_joints.h"
#include "support/free_linkages.h"

namespace clevis::mechanism {
namespace {

/// Four-bar of cranks 1 and 1.2, coupler 1.1, ground 1.5 m.
MechanismDefinition four_bar() {
  MechanismDefinition m;
  m.dimension = SpaceDimension::kPlanar;
  m.bodies = {testing::uniform_bar("crank", {0.0, 0.0, 0.0}, 1.2, 1.0),
              testing::uniform_bar("coupler", {0.36, 0.93, 0.0}, 0.1, 1.1),
              testing::uniform_bar("rocker", {1.5, 0.0, 0.0}, 1.6, 1.2)};
  m.joints = {testing::pin("A", kGround, 0, 0.0, 0.0),
              testing::pin("B", 0, 1, 1.0, 0.0),
              testing::pin("C", 1, 2, 1.1, 1.2),
              testing::pin("D", kGround, 2, 1.5, 0.0)};
  return m;
}

DriveDefinition drive_of(int joint) {
  DriveDefinition drive;
  drive.joint = joint;
  drive.place = "drive " + std::to_string(joint);
  return drive;
}

Mobility mobility_of(const MechanismDefinition& m, Motions motions) {
  const SolvingFrame frame(m);
  const ConstraintSystem system(frame, m.drives, motions,
                                ConstraintSystem::Drives::kAll);
  return mobility(frame, system, closed_joints(m, frame, 1e-10));
}

// Gruebler: 3 (4 − 1) − 2 × 4 = 1.
TEST(Mobility, OfAFourBarInItsPlane) {
  MechanismDefinition m = four_bar();
  Mobility found = mobility_of(m, Motions::kInPlane);
  EXPECT_EQ(found.joints, 1);
  EXPECT_EQ(found.with_drives, 1);
  EXPECT_EQ(found.redundant, 0);
  m.drives = {drive_of(0)};
  found = mobility_of(m, Motions::kInPlane);
  EXPECT_EQ(found.with_drives, 0);
  EXPECT_TRUE(found.free_coordinates.empty());
  EXPECT_NO_THROW(require_driven(m, found));
}

// In space the same: 6 × 3 − 5 × 4 = −2, but 1, so three rows are redundant.
TEST(Mobility, OfAFourBarInSpace) {
  MechanismDefinition m = four_bar();
  m.dimension = SpaceDimension::kSpatial;
  const Mobility found = mobility_of(m, Motions::kSpatial);
  EXPECT_EQ(found.joints, 1);
  EXPECT_EQ(found.redundant, 3);
}

std::string code_of(const MechanismDefinition& m) {
  try {
    require_driven(m, mobility_of(m, Motions::kInPlane));
  } catch (const Error& error) {
    return std::string(error.code());
  }
  return "none";
}

TEST(Mobility, AsksForDrivesAndRefusesOnesTooMany) {
  MechanismDefinition m = four_bar();
  EXPECT_EQ(code_of(m), "K002");
  m.drives = {drive_of(0)};
  EXPECT_EQ(code_of(m), "none");
  m.drives = {drive_of(0), drive_of(3)};
  EXPECT_EQ(code_of(m), "K003");
}

// A parallelogram in line is singular; its neighbours on the branch are not.
TEST(Mobility, IsThatBesideASingularPosition) {
  MechanismDefinition m;
  m.dimension = SpaceDimension::kPlanar;
  m.bodies = {testing::uniform_bar("crank", {0.0, 0.0, 0.0}, 0.0, 1.0),
              testing::uniform_bar("coupler", {1.0, 0.0, 0.0}, 0.0, 2.0),
              testing::uniform_bar("rocker", {2.0, 0.0, 0.0}, 0.0, 1.0)};
  m.joints = {testing::pin("A", kGround, 0, 0.0, 0.0),
              testing::pin("B", 0, 1, 1.0, 0.0),
              testing::pin("C", 1, 2, 2.0, 1.0),
              testing::pin("D", kGround, 2, 2.0, 0.0)};
  EXPECT_EQ(mobility_of(m, Motions::kInPlane).joints, 1);
}

}  // namespace
}  // namespace clevis::mechanism
