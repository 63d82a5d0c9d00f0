#include <string>

#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "mechanism/simulate.h"
#include "support/four_bar.h"

namespace clevis::mechanism {
namespace {

using namespace testing;

/// "K001 problem remedy" of the refusal, or "".
std::string refusal(const MechanismDefinition& m) {
  try {
    simulate(m,
             {.duration = 2.0, .instants = 51, .motion = MotionKind::kDriven});
  } catch (const Error& error) {
    return error.code() + " " + error.place() + ": " + error.problem() + "; " +
           error.remedy();
  }
  return "";
}

bool has(const std::string& text, const char* part) {
  return text.find(part) != std::string::npos;
}

TEST(Refusal, LoopThatCannotClose) {
  FourBar l;
  MechanismDefinition m = four_bar(l, 0.7);
  m.joints[3].frame_a.p_LJ.x() = 0.5;  // G out of reach: 0.35 m of links
  const std::string why = refusal(m);
  EXPECT_TRUE(has(why, "K001")) << why;
  EXPECT_TRUE(has(why, " mm")) << why;
  EXPECT_TRUE(has(why, "Q by")) << why;
}

TEST(Refusal, BodyThatWasPlacedInAnotherUnitIsNamed) {
  MechanismDefinition m = four_bar({}, 0.7);
  m.joints[3].frame_a.p_LJ.x() = 0.5;  // G out of reach
  EXPECT_FALSE(has(refusal(m), "placement of body")) << refusal(m);
  m.bodies[1].placement.p_WL = {240.0, 0.0, 0.0};
  EXPECT_TRUE(has(refusal(m), ("The placement of body " + m.bodies[1].name +
                               " is 2.4e+05 mm off all of its joints")
                                  .c_str()))
      << refusal(m);
}

// A motion that drives fix has no steps to forecast, but positions to count.
TEST(Refusal, DrivenMotionThatTakesTooLong) {
  for (const bool at_peaks : {false, true}) {
    SimulationSettings settings{.duration = 2.0, .instants = 2001};
    settings.at_peaks = at_peaks;
    settings.max_time = 1e-5;
    try {
      simulate(four_bar({}, 0.7), settings);
      FAIL() << "2001 instants within 10 us";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), "K013");
      EXPECT_TRUE(has(error.problem(), "1e-05 s are allowed"))
          << error.problem();
      EXPECT_TRUE(has(error.remedy(), "--max-time")) << error.remedy();
    }
  }
}

TEST(Refusal, DriveThatStartsOutOfReach) {
  MechanismDefinition m = landing_gear();
  m.drives[0].from = 0.300;  // beyond FD + ED = 270.24 mm
  const std::string why = refusal(m);
  EXPECT_TRUE(has(why, "K001")) << why;
  EXPECT_TRUE(has(why, "drives at their start")) << why;
}

TEST(Refusal, UnderDriven) {
  MechanismDefinition m = landing_gear();
  m.drives.clear();
  const std::string why = refusal(m);
  EXPECT_TRUE(has(why, "K002")) << why;
  EXPECT_TRUE(has(why, "cylinder")) << why;
  EXPECT_TRUE(has(why, "1 degree(s) of freedom")) << why;
}

TEST(Refusal, UnderDrivenNamesOnlyWhatIsLoose) {
  MechanismDefinition m = landing_gear();
  BodyDefinition flap = m.bodies[kFE2];
  flap.name = "flap";
  m.bodies.push_back(flap);
  JointDefinition hinge = m.joints[kE];
  hinge.name = "flap hinge";
  hinge.body_b = 6;
  m.joints.push_back(hinge);
  const std::string why = refusal(m);
  EXPECT_TRUE(has(why, "K002")) << why;
  EXPECT_TRUE(has(why, "joints flap hinge")) << why;
}

TEST(Refusal, OverDriven) {
  MechanismDefinition m = landing_gear();
  DriveDefinition second;
  second.joint = kD;
  second.place = "second";
  m.drives.push_back(second);
  const std::string why = refusal(m);
  EXPECT_TRUE(has(why, "K003 second")) << why;
  EXPECT_TRUE(has(why, "cylinder, D")) << why;
  EXPECT_TRUE(has(why, "Remove 1 ")) << why;
}

TEST(Refusal, StrokePastTheDeadCentre) {
  MechanismDefinition m = landing_gear();
  m.drives[0].to = 0.280;  // the triangle FED ends at 270.24 mm
  const std::string why = refusal(m);
  EXPECT_TRUE(has(why, "K004")) << why;
  EXPECT_TRUE(has(why, "cylinder at 270.2")) << why;
}

TEST(Refusal, MasslessBody) {
  MechanismDefinition m = landing_gear();
  m.bodies[kBodyBC].mass_properties.mass = 0.0;
  const std::string why = refusal(m);
  EXPECT_TRUE(has(why, "K006 body BC")) << why;
}

TEST(Refusal, PlanarThatIsNot) {
  MechanismDefinition m = landing_gear();
  m.dimension = SpaceDimension::kPlanar;
  m.joints[kE].frame_a.R_LJ = m.joints[kE].frame_b.R_LJ =
      Eigen::AngleAxisd(0.1, Vector3d::UnitX()).toRotationMatrix();
  const std::string why = refusal(m);
  EXPECT_TRUE(has(why, "S010 joint E")) << why;
}

TEST(Refusal, LoopOpenAlongThePins) {
  MechanismDefinition m = landing_gear();
  m.joints[kB].frame_b.p_LJ.z() = 0.003;
  const std::string why = refusal(m);
  EXPECT_TRUE(has(why, "K001")) << why;
  EXPECT_TRUE(has(why, "along the normal")) << why;
  EXPECT_TRUE(has(why, "D by 3 mm along its axis, cylinder by 3 mm; ")) << why;
  EXPECT_TRUE(has(why, " mm are allowed; What turns about one pin")) << why;
  // Both loops stay open at other joints than the one to correct.
  EXPECT_TRUE(has(why, "apart along their axes at B by 3 mm. Change")) << why;
}

TEST(Refusal, LoopOpenAcrossThePinsSaysNothingOfHeights) {
  FourBar l;
  MechanismDefinition m = four_bar(l, 0.7);
  m.joints[3].frame_a.p_LJ.x() = 0.5;
  const std::string why = refusal(m);
  EXPECT_FALSE(has(why, "along its axis")) << why;
  EXPECT_FALSE(has(why, "meant parallel")) << why;
  EXPECT_TRUE(has(why, "; Correct the lengths")) << why;
}

// A planar loop with one axis a little off is a spatial one that jams.
TEST(Refusal, AxesMeantParallelAreNamed) {
  MechanismDefinition m = four_bar({}, 0.7);
  m.joints[2].frame_a.R_LJ = m.joints[2].frame_b.R_LJ =
      Eigen::AngleAxisd(1e-5, Vector3d::UnitX()).toRotationMatrix();
  const std::string why = refusal(m);
  EXPECT_TRUE(has(why, "K001")) << why;
  EXPECT_TRUE(has(why, "differ by 0.000573 deg: if they are meant parallel"))
      << why;
}

}  // namespace
}  // namespace clevis::mechanism
