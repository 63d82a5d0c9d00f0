#include "report/summary/motion_notes.h"

#include <gtest/gtest.h>

namespace clevis::report {
namespace {

using namespace mechanism;

std::string only_note(const MechanismDefinition& definition,
                      const Motion& motion) {
  const auto notes = motion_notes(definition, motion);
  EXPECT_EQ(notes.size(), 1u);
  return notes.empty() ? "" : notes.front();
}

/// Whether a text holds another.
bool tells(const std::string& text, const char* what) {
  return text.find(what) != std::string::npos;
}

/// A motion that was integrated as one coordinate was left free.
Motion left_free() {
  Motion motion;
  motion.left_free = LeftFree{.freedom = 1, .coordinates = {"hinge"}};
  return motion;
}

TEST(MotionNotes, NothingIsSaidOfAMotionThatDrivesFix) {
  EXPECT_TRUE(motion_notes({}, {}).empty());
}

// Weight alone moves it: a drive was probably forgotten.
TEST(MotionNotes, ForgottenDriveIsAskedFor) {
  const std::string note = only_note({}, left_free());
  EXPECT_TRUE(tells(note, "no drive fixes 1 degree of freedom (hinge)"));
  EXPECT_TRUE(tells(note, "from rest, in the position of the placements"));
  EXPECT_TRUE(tells(note, "drive was forgotten, add it"));
  EXPECT_TRUE(tells(note, "motion = \"dynamic\""));
}

TEST(MotionNotes, StartWithARateIsMeant) {
  MechanismDefinition definition;
  definition.initial_joints.resize(1);
  definition.initial_joints[0].position = 0.3;
  definition.initial_joints[0].rate = 2.0;
  const std::string note = only_note(definition, left_free());
  EXPECT_TRUE(tells(note, "from the rates of [[initial]]"));
  EXPECT_TRUE(tells(note, "in the position of [[initial]]"));
  EXPECT_FALSE(tells(note, "forgotten"));
}

TEST(MotionNotes, HistoryOfForcesIsNoFreedom) {
  Motion motion;
  motion.left_free = LeftFree{};
  const std::string note = only_note({}, motion);
  EXPECT_TRUE(tells(note, "history"));
  EXPECT_FALSE(tells(note, "no drive fixes"));
}

}  // namespace
}  // namespace clevis::report
