#include "report/notes/definition_notes.h"

#include <gtest/gtest.h>

namespace clevis::report {
namespace {

using namespace mechanism;

std::vector<std::string> notes_on(const MechanismDefinition& definition) {
  std::vector<std::string> notes;
  add_definition_notes(definition, notes);
  return notes;
}

std::string only_note(const MechanismDefinition& definition) {
  const auto notes = notes_on(definition);
  EXPECT_EQ(notes.size(), 1u);
  return notes.empty() ? "" : notes.front();
}

/// Whether a text holds another.
bool tells(const std::string& text, const char* what) {
  return text.find(what) != std::string::npos;
}

// 9810 m/s² were meant as mm/s²; Jupiter has 25.
TEST(DefinitionNotes, GravityThatNoMachineMeetsIsAskedAbout) {
  MechanismDefinition definition;
  definition.gravity_W = {0.0, -25.0, 0.0};
  EXPECT_TRUE(notes_on(definition).empty());
  definition.gravity_W = {0.0, 0.0, -9810.0};
  const std::string note = only_note(definition);
  EXPECT_TRUE(tells(note, "gravity is 9810 m/s^2, 1000 times the earth's"));
  EXPECT_TRUE(tells(note, "see that its unit is right"));
  definition.gravity_W = {0.0, 0.0, -9.81e-3};
  EXPECT_TRUE(tells(only_note(definition), "gravity is 0.00981 m/s^2"));
  definition.gravity_W = {0.0, 0.0, -1.6};
  EXPECT_TRUE(notes_on(definition).empty());
}

// A steel bar of 120 × 20 × 10 mm, its mass of 188 g typed as kg.
TEST(DefinitionNotes, BodyDenserThanAnyIsAskedAbout) {
  MechanismDefinition definition;
  definition.bodies.resize(1);
  BodyDefinition& body = definition.bodies[0];
  body.name = "crank";
  body.mass_properties.mass = 0.188;
  body.mass_properties.inertia_LCm.diagonal() << 7.8e-6, 227e-6, 232e-6;
  EXPECT_TRUE(notes_on(definition).empty());
  body.mass_properties.mass = 188.0;
  const std::string note = only_note(definition);
  EXPECT_TRUE(tells(note, "body crank of 188 kg"));
  EXPECT_TRUE(tells(note, "units of its mass and inertia"));
  // A ball of lead is no denser than lead, whatever its size.
  const double mass = 4.0 / 3.0 * 3.14159 * 1e-9 * 11340.0;  // of 1 mm
  body.mass_properties.mass = mass;
  body.mass_properties.inertia_LCm =
      0.4 * mass * 1e-6 * Eigen::Matrix3d::Identity();
  EXPECT_TRUE(notes_on(definition).empty());
  body.mass_properties.inertia_LCm *= 1e-2;  // radius/10, density·1000
  EXPECT_TRUE(tells(only_note(definition), "1.1e+07 kg/m^3"));
}

// Mass and inertia wrong by the same factor keep the radius of gyration.
TEST(DefinitionNotes, MassAndInertiaWrongByOneFactorAreAskedAbout) {
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
  EXPECT_TRUE(notes_on(definition).empty());
  take(1e3);
  EXPECT_TRUE(tells(only_note(definition), "so little inertia"));
  take(1e-3);
  EXPECT_TRUE(tells(only_note(definition), "5.5 kg/m^3 as a solid"));
  // A lamina's inertia, as of planar mechanisms: 140 × 20 × 5 mm, 0.11 kg.
  given.mass = 0.11;
  given.inertia_LCm.diagonal() << 3.67e-6, 179.7e-6, 183.37e-6;
  EXPECT_TRUE(notes_on(definition).empty());
}

// A rocker of 200 mm, its centre of mass 600 mm away for 60.
TEST(DefinitionNotes, CentreOfMassFarFromItsJointsIsAskedAbout) {
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
  EXPECT_TRUE(notes_on(definition).empty());
  body.mass_properties.p_LCm = {0.2, 0.66, 0.0};
  const std::string note = only_note(definition);
  EXPECT_TRUE(tells(note,
                    "body rocker is 660 mm from its nearest joint, 3.3 "
                    "times as far as its joints are apart (200 mm)"))
      << note;
  body.part = "rocker";  // its mesh tells where its mass is
  EXPECT_TRUE(notes_on(definition).empty());
  body.part.clear();
  definition.joints.pop_back();  // a pendulum's bob
  EXPECT_TRUE(notes_on(definition).empty());
  part::MassProperties& given = body.mass_properties;
  given.mass = 1.0;
  given.inertia_LCm = 0.4 * 1e-4 * Eigen::Matrix3d::Identity();  // 10 mm
  given.p_LCm = {0.15, 0.0, 0.0};
  EXPECT_TRUE(notes_on(definition).empty());
  given.p_LCm = {150.0, 0.0, 0.0};
  EXPECT_TRUE(tells(only_note(definition),
                    "body rocker is 1.5e+05 mm from its joint, 9.68e+03 times"))
      << only_note(definition);
}

// 80 mm between the axes, and "12 m" for 12 mm.
TEST(DefinitionNotes, TeethFarBesideTheirWheelAreAskedAbout) {
  MechanismDefinition definition;
  definition.joints.resize(2);
  definition.joints[0].body_b = 0;
  definition.joints[1].body_b = 1;
  definition.joints[1].frame_a.p_LJ = {0.08, 0.0, 0.0};
  CouplingDefinition& mesh = definition.couplings.emplace_back();
  mesh.name = "mesh";
  mesh.joint_2 = 1;
  mesh.ratio = -3.0;
  mesh.teeth.emplace().mid_face = 0.012;
  EXPECT_TRUE(notes_on(definition).empty());
  mesh.teeth->mid_face = 12.0;
  EXPECT_TRUE(tells(only_note(definition),
                    "mesh: its teeth stand 1.2e+04 mm beside its joint, 200 "
                    "times their pitch radius"));
}

// By joints from the body's origin, or by twice the radius of gyration.
TEST(DefinitionNotes, SizeOfAMechanismIsThatOfItsLargestBody) {
  MechanismDefinition definition;
  EXPECT_EQ(mechanism_size(definition), 0.0);
  definition.bodies.resize(1);
  definition.bodies[0].mass_properties.mass = 2.0;
  definition.bodies[0].mass_properties.inertia_LCm.diagonal() << 0.0, 0.08,
      0.08;
  EXPECT_DOUBLE_EQ(mechanism_size(definition), 0.4);
  definition.joints.resize(1);
  definition.joints[0].body_a = kGround;
  definition.joints[0].frame_a.p_LJ = {9.0, 0.0, 0.0};
  definition.joints[0].body_b = 0;
  definition.joints[0].frame_b.p_LJ = {0.0, 0.7, 0.0};
  EXPECT_DOUBLE_EQ(mechanism_size(definition), 0.7);
}

}  // namespace
}  // namespace clevis::report
