#include "report/notes/motion_notes.h"

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

/// Of one drive of a hinge, by its law, at the start and the end of a second.
Motion driven_to(MechanismDefinition& definition, const DriveDefinition& drive,
                 double end) {
  definition.joints.resize(1);
  definition.joints[0].name = "hinge";
  definition.joints[0].type = JointType::kRevolute;
  definition.drives = {drive};
  Motion motion;
  motion.instants.resize(2);
  motion.instants[1].t = 1.0;
  for (Instant& instant : motion.instants) instant.drives.resize(1);
  motion.instants[1].drives[0].position = end;
  return motion;
}

TEST(MotionNotes, DriveThatHardlyTurnsIsAskedAbout) {
  MechanismDefinition definition;
  const DriveDefinition speed{.law = DriveLaw::kSpeed, .speed = 0.05};
  Motion motion = driven_to(definition, speed, 0.05);
  const std::string note = only_note(definition, motion);
  EXPECT_TRUE(tells(note,
                    "the drive of hinge turns by 2.86 deg over the whole "
                    "motion of 1 s"))
      << note;
  motion = driven_to(definition, speed, 0.07);
  EXPECT_TRUE(motion_notes(definition, motion).empty());
  // One that is to turn no farther, and one that ends before it has.
  const DriveDefinition small{
      .law = DriveLaw::kQuintic, .to = 0.05, .duration = 1.0};
  motion = driven_to(definition, small, 0.05);
  EXPECT_TRUE(motion_notes(definition, motion).empty());
  const DriveDefinition cut{
      .law = DriveLaw::kQuintic, .to = 1.0, .duration = 1e3};
  motion = driven_to(definition, cut, 1e-6);
  EXPECT_TRUE(tells(only_note(definition, motion), "turns by 5.73e-05 deg"));
  // A millimetre is no angle.
  motion = driven_to(definition, speed, 0.001);
  definition.joints[0].type = JointType::kPrismatic;
  EXPECT_TRUE(motion_notes(definition, motion).empty());
}

TEST(MotionNotes, SlideThatHardlyMovesIsAskedAbout) {
  MechanismDefinition definition;
  const auto note_of = [&](const DriveDefinition& drive, double end) {
    const Motion motion = driven_to(definition, drive, end);
    definition.joints[0].type = JointType::kPrismatic;
    const auto notes = motion_notes(definition, motion);
    return notes.empty() ? "" : notes.front();
  };
  const DriveDefinition stroke{
      .law = DriveLaw::kQuintic, .from = 0.16, .to = 0.26, .duration = 2e3};
  EXPECT_TRUE(tells(note_of(stroke, 0.0005),
                    "the drive of hinge moves by 0.5 mm over the whole motion "
                    "of 1 s, less than a hundredth of the 100 mm of its law"));
  EXPECT_EQ(note_of(stroke, 0.0011), "");
  const DriveDefinition sine{.law = DriveLaw::kSine, .amplitude = 0.02};
  EXPECT_NE(note_of(sine, 1e-4), "");
  EXPECT_EQ(note_of(sine, 1e-3), "");
  DriveDefinition table{.law = DriveLaw::kTable};
  table.table.values = {0.1, 0.3, 0.2};
  EXPECT_TRUE(tells(note_of(table, 1e-3), "of the 200 mm of its law"));
  EXPECT_EQ(note_of(table, 3e-3), "");
  const DriveDefinition still{.law = DriveLaw::kConstant};
  EXPECT_EQ(note_of(still, 0.0), "");
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

// Drives set a joint in motion: friction slides at once.
TEST(MotionNotes, BreakawayThatIsInNoLoadIsTold) {
  FrictionLaw law;
  law.breakaway = 120.0;
  law.kinetic = 60.0;
  MechanismDefinition definition;
  const auto put = [&] {
    LineElement rub;
    rub.name = "rub";
    rub.law = law;
    rub.line.joint = 0;
    definition.joints.resize(1);
    definition.elements = {rub};
  };
  put();
  Motion motion;
  motion.instants.resize(3);
  for (Instant& instant : motion.instants) instant.elements.resize(1);
  EXPECT_TRUE(motion_notes(definition, motion).empty());  // it rests
  motion.instants[1].elements[0].rate = 0.3;
  const std::string note = only_note(definition, motion);
  EXPECT_TRUE(tells(note, "friction rub"));
  EXPECT_TRUE(tells(note, "2 times"));
  EXPECT_TRUE(tells(note, "stribeck_speed"));
  motion.instants[0].elements[0].rate = 0.2;
  motion.instants[2].elements[0].rate = 0.1;
  EXPECT_TRUE(motion_notes(definition, motion).empty());  // slides throughout
  motion.instants[2].elements[0].rate = -0.1;
  EXPECT_EQ(motion_notes(definition, motion).size(), 1u);
  law.kinetic = 0.0;
  put();
  EXPECT_TRUE(tells(only_note(definition, motion), "sliding none"));
  law.stribeck_speed = 1e-3;
  put();
  EXPECT_TRUE(motion_notes(definition, motion).empty());
  law.stribeck_speed = 0.0;
  law.kinetic = law.breakaway;
  put();
  EXPECT_TRUE(motion_notes(definition, motion).empty());
}

TEST(MotionNotes, HistoryOfForcesIsNoFreedom) {
  Motion motion;
  motion.left_free = LeftFree{};
  const std::string note = only_note({}, motion);
  EXPECT_TRUE(tells(note, "history"));
  EXPECT_FALSE(tells(note, "no drive fixes"));
}

/// One body with a joint 100 mm from its origin, over some instants of an
/// integrated motion.
Motion integrated(MechanismDefinition& definition, std::size_t instants,
                  double duration) {
  definition.bodies.resize(1);
  definition.bodies[0].name = "bob";
  definition.bodies[0].is_placed = true;
  definition.joints.resize(1);
  definition.joints[0].body_a = kGround;
  definition.joints[0].body_b = 0;
  definition.joints[0].frame_b.p_LJ = {0.1, 0.0, 0.0};
  Motion motion;
  motion.integration.emplace();
  motion.instants.resize(instants);
  for (std::size_t i = 0; i < instants; ++i) {
    motion.instants[i].t =
        duration * static_cast<double>(i) / static_cast<double>(instants - 1);
    motion.instants[i].bodies.resize(1);
  }
  return motion;
}

TEST(MotionNotes, MotionThatEndsBeforeAnythingMovesIsAskedAbout) {
  MechanismDefinition definition;
  Motion motion = integrated(definition, 3, 2e-3);
  EXPECT_TRUE(motion_notes(definition, motion).empty());  // at rest
  for (std::size_t i = 0; i < 3; ++i) {                   // falls
    const double t = motion.instants[i].t;
    BodyState& body = motion.instants[i].bodies[0];
    body.v_WLo = {0.0, -9.81 * t, 0.0};
    body.pose.p_WL = {0.0, -0.5 * 9.81 * t * t, 0.0};
  }
  const std::string note = only_note(definition, motion);
  EXPECT_TRUE(tells(note,
                    "moves by more than 0.0196 mm or turns by more than "
                    "0 deg over the motion of 0.002 s"))
      << note;
  // A pin that rests but for round-off, about which the body turns.
  Motion pinned = motion;
  for (std::size_t i = 0; i < 3; ++i) {
    BodyState& body = pinned.instants[i].bodies[0];
    body.v_WLo = {0.0, i == 1 ? -1e-16 : 1e-16, 0.0};
    body.w_WL = {0.0, 0.0, 6.0};
    body.pose = {};
  }
  EXPECT_EQ(motion_notes(definition, pinned).size(), 1u);
  // One that comes to rest, and one that turns back.
  motion.instants[2].bodies[0].v_WLo *= 0.2;
  EXPECT_TRUE(motion_notes(definition, motion).empty());
  motion.instants[2].bodies[0].v_WLo *= -5.0;
  EXPECT_TRUE(motion_notes(definition, motion).empty());
}

TEST(MotionNotes, BodyFasterThanSoundIsAskedAbout) {
  MechanismDefinition definition;
  Motion motion = integrated(definition, 2, 1.0);
  motion.instants[1].bodies[0].w_WL = {0.0, 0.0, 6000.0};
  motion.instants[1].bodies[0].pose.p_WL.x() = 0.01;
  definition.bodies[0].mass_properties.p_LCm = {0.05, 0.0, 0.0};  // 300 m/s
  EXPECT_TRUE(motion_notes(definition, motion).empty());
  definition.bodies[0].mass_properties.p_LCm = {0.06, 0.0, 0.0};
  EXPECT_TRUE(
      tells(only_note(definition, motion), "body bob moves at 360 m/s"));
}

TEST(MotionNotes, AccelerationThatNoDriveGivesIsAskedAbout) {
  MechanismDefinition definition;
  Motion motion = integrated(definition, 2, 1.0);
  motion.instants[0].bodies[0].a_WLo = {2.1e4, 0.0, 0.0};
  EXPECT_TRUE(motion_notes(definition, motion).empty());  // a blow
  motion.integration.reset();
  EXPECT_TRUE(tells(only_note(definition, motion),
                    "body bob is accelerated by 2.1e+04 m/s^2"));
  motion.instants[0].bodies[0].a_WLo = {1.9e4, 0.0, 0.0};
  EXPECT_TRUE(motion_notes(definition, motion).empty());
}

TEST(MotionNotes, StrainsThatJointsDoNotShareAreTold) {
  MechanismDefinition definition;
  Motion motion = integrated(definition, 3, 1.0);
  motion.unshared.spun = {0};
  EXPECT_TRUE(only_note(definition, motion).starts_with("bob: ")) << "spun";
  EXPECT_NE(only_note(definition, motion).find("\"elastic\""),
            std::string::npos);
  motion.unshared = {.spun = {}, .loaded = {0}};
  EXPECT_NE(only_note(definition, motion).find("links = \"rigid\""),
            std::string::npos);
}

}  // namespace
}  // namespace clevis::report
