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

// 9810 m/s² were meant as mm/s²; Jupiter has 25.
TEST(MotionNotes, GravityThatNoMachineMeetsIsAskedAbout) {
  MechanismDefinition definition;
  definition.gravity_W = {0.0, -25.0, 0.0};
  EXPECT_TRUE(motion_notes(definition, {}).empty());
  definition.gravity_W = {0.0, 0.0, -9810.0};
  const std::string note = only_note(definition, {});
  EXPECT_TRUE(tells(note, "gravity is 9810 m/s^2, 1000 times the earth's"));
  EXPECT_TRUE(tells(note, "see that its unit is right"));
  definition.gravity_W = {0.0, 0.0, -9.81e-3};
  EXPECT_TRUE(tells(only_note(definition, {}), "gravity is 0.00981 m/s^2"));
  definition.gravity_W = {0.0, 0.0, -1.6};
  EXPECT_TRUE(motion_notes(definition, {}).empty());
}

// A steel bar of 120 × 20 × 10 mm, its mass of 188 g typed as kg.
TEST(MotionNotes, BodyDenserThanAnyIsAskedAbout) {
  MechanismDefinition definition;
  definition.bodies.resize(1);
  BodyDefinition& body = definition.bodies[0];
  body.name = "crank";
  body.mass_properties.mass = 0.188;
  body.mass_properties.inertia_LCm.diagonal() << 7.8e-6, 227e-6, 232e-6;
  EXPECT_TRUE(motion_notes(definition, {}).empty());
  body.mass_properties.mass = 188.0;
  const std::string note = only_note(definition, {});
  EXPECT_TRUE(tells(note, "body crank of 188 kg"));
  EXPECT_TRUE(tells(note, "units of its mass and inertia"));
  // A ball of lead is no denser than lead, whatever its size.
  const double mass = 4.0 / 3.0 * 3.14159 * 1e-9 * 11340.0;  // of 1 mm
  body.mass_properties.mass = mass;
  body.mass_properties.inertia_LCm =
      0.4 * mass * 1e-6 * Eigen::Matrix3d::Identity();
  EXPECT_TRUE(motion_notes(definition, {}).empty());
  body.mass_properties.inertia_LCm *= 1e-2;  // radius/10, density·1000
  EXPECT_TRUE(tells(only_note(definition, {}), "1.1e+07 kg/m^3"));
}

// Mass and inertia wrong by the same factor keep the radius of gyration.
TEST(MotionNotes, MassAndInertiaWrongByOneFactorAreAskedAbout) {
  MechanismDefinition definition;
  definition.bodies.resize(1);
  BodyDefinition& body = definition.bodies[0];
  body.name = "rod";
  part::MassProperties& given = body.mass_properties;
  const auto take = [&](double factor) {
    // A round bar of steel, 1 m long, 20 mm thick.
    given.mass = factor * 2.466;
    given.inertia_LCm.diagonal() << factor * 1.233e-4, factor * 0.20556,
        factor * 0.20556;
  };
  take(1.0);
  EXPECT_TRUE(motion_notes(definition, {}).empty());
  take(1e3);
  EXPECT_TRUE(tells(only_note(definition, {}), "so little inertia"));
  take(1e-3);
  EXPECT_TRUE(tells(only_note(definition, {}), "5.5 kg/m^3 as a solid"));
  // A lamina's inertia, as of planar mechanisms: 140 × 20 × 5 mm, 0.11 kg.
  given.mass = 0.11;
  given.inertia_LCm.diagonal() << 3.67e-6, 179.7e-6, 183.37e-6;
  EXPECT_TRUE(motion_notes(definition, {}).empty());
}

// A rocker of 200 mm, its centre of mass 600 mm away for 60.
TEST(MotionNotes, CentreOfMassFarFromItsJointsIsAskedAbout) {
  MechanismDefinition definition;
  definition.bodies.resize(1);
  BodyDefinition& body = definition.bodies[0];
  body.name = "rocker";
  definition.joints.resize(2);
  definition.joints[0].body_b = 0;
  definition.joints[1].body_a = 0;
  definition.joints[1].body_b = kGround;
  definition.joints[1].frame_a.p_LJ = {0.2, 0.0, 0.0};
  body.mass_properties.p_LCm = {-0.6, 0.0, 0.0};
  EXPECT_TRUE(motion_notes(definition, {}).empty());
  body.mass_properties.p_LCm = {0.2, 0.66, 0.0};
  const std::string note = only_note(definition, {});
  EXPECT_TRUE(tells(note,
                    "body rocker is 660 mm from its nearest joint, 3.3 "
                    "times as far as its joints are apart (200 mm)"))
      << note;
  body.part = "rocker";  // its mesh tells where its mass is
  EXPECT_TRUE(motion_notes(definition, {}).empty());
  body.part.clear();
  definition.joints.pop_back();  // a pendulum's bob
  EXPECT_TRUE(motion_notes(definition, {}).empty());
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

}  // namespace
}  // namespace clevis::report
