#include "assessment/notes/part_notes.h"

#include <gtest/gtest.h>

#include "support/structured_mesh.h"

namespace clevis::assessment {
namespace {

using Eigen::Vector3d;

/// Of 200 × 20 × 10 mm, 201 mm from corner to corner.
PartJob steel_link() {
  PartJob job;
  job.part.material = {"steel", 210e9, 0.3, 7850.0, 355e6};
  job.part.limits.deflection = 0.5e-3;
  job.mesh = support::structured_mesh<3>(
      {1, 1, 1}, 1, [](const Vector3d& x) -> Vector3d {
        return x.cwiseProduct(Vector3d(0.2, 0.02, 0.01));
      });
  return job;
}

std::string only_note(const PartJob& job) {
  const auto notes = part_notes(job);
  EXPECT_EQ(notes.size(), 1u);
  return notes.empty() ? "" : notes.front();
}

/// Notes behind that of its size, of a part that stands alone.
std::vector<std::string> asked(const PartJob& job) {
  auto notes = part_notes(job);
  EXPECT_TRUE(notes.at(0).starts_with("size ")) << notes.at(0);
  notes.erase(notes.begin());
  return notes;
}

std::string only_asked(const PartJob& job) {
  const auto notes = asked(job);
  EXPECT_EQ(notes.size(), 1u);
  return notes.empty() ? "" : notes.front();
}

TEST(PartNotes, NothingIsSaidOfASoundPart) {
  EXPECT_TRUE(part_notes(steel_link()).empty());
}

TEST(PartNotes, SizeOfFewLinksIsAskedAbout) {
  PartJob job = steel_link();
  for (Vector3d& vertex : job.mesh.vertices) vertex *= 100.0;
  EXPECT_EQ(only_note(job),
            "the part is 20.1 m large: see that the unit of its lengths is "
            "right");
}

TEST(PartNotes, YieldStrengthOfNoMaterialIsAskedAbout) {
  PartJob job = steel_link();
  job.part.material.yield_strength = 355e3;  // kPa for MPa
  EXPECT_EQ(only_note(job),
            "the yield strength of steel is 0.355 MPa, outside 1 MPa to 2.5 "
            "GPa: see that its unit is right");
  job.part.material.yield_strength = 3.55e9;
  EXPECT_NE(only_note(job).find("3550 MPa"), std::string::npos);
  for (const double sound : {1e6, 2.5e9}) {
    job.part.material.yield_strength = sound;
    EXPECT_TRUE(part_notes(job).empty()) << sound;
  }
}

TEST(PartNotes, DeflectionLimitAsLargeAsThePartIsAskedAbout) {
  PartJob job = steel_link();
  job.part.limits.deflection = 0.01;
  EXPECT_TRUE(part_notes(job).empty());
  job.part.limits.deflection = 0.02;  // cm for mm
  EXPECT_EQ(only_note(job),
            "the limit of deflection is 20 mm, more than a 20th of the part's "
            "size (201.2 mm): see that its unit is right");
  job.part.limits.deflection.reset();
  EXPECT_TRUE(part_notes(job).empty());
}

TEST(PartNotes, CaseThatIsNothingBesideAnotherIsAskedAbout) {
  PartJob job = steel_link();
  job.part.cases.resize(2);
  job.part.cases[0].name = "push";
  job.part.cases[0].pins = {{"bore_A", {-5000.0, 0.0, 0.0}}};
  job.part.cases[1].name = "pull";
  job.part.cases[1].pins = {{"bore_A", {0.0, 20.0, 0.0}}};
  EXPECT_TRUE(asked(job).empty());
  job.part.cases[1].pins["bore_A"].y() = 5.0;  // kN
  EXPECT_EQ(only_asked(job),
            "the largest force of case pull is 5 N, that of case push 5000 N: "
            "see that the units of both are right");
}

TEST(PartNotes, AccelerationAsOfMillimetresIsAskedAbout) {
  PartJob job = steel_link();
  part::LoadSeries& bench = job.part.series.emplace_back();
  bench.name = "bench";
  bench.instants.resize(2);
  bench.instants[1].acceleration.y() = 400.0;
  EXPECT_TRUE(asked(job).empty());
  bench.instants[1].acceleration.y() = 2000.0;  // 2 m/s²
  EXPECT_EQ(only_asked(job),
            "history bench: its acceleration minus gravity is 2000 m/s^2, "
            "203.9 times the "
            "earth's gravity: see that its unit is right");
  job.part.series.clear();
  part::LoadCaseDefinition& drop = job.part.cases.emplace_back();
  drop.name = "drop";
  drop.acceleration.y() = 400.0;
  EXPECT_TRUE(asked(job).empty());
  drop.acceleration.y() = 2000.0;
  EXPECT_EQ(only_asked(job),
            "case drop: its acceleration minus gravity is 2000 m/s^2, 203.9 "
            "times the earth's "
            "gravity: see that its unit is right");
}

// Nothing else says what its mesh's numbers were taken for.
TEST(PartNotes, SizeAndMassOfAPartThatStandsAloneAreTold) {
  PartJob job = steel_link();
  job.mass.mass = 0.314;
  EXPECT_TRUE(part_notes(job).empty());
  job.part.cases.resize(1);
  EXPECT_EQ(only_note(job), "size 200 x 20 x 10 mm, 0.314 kg");
  for (Vector3d& vertex : job.mesh.vertices) vertex *= 10.0;  // cm for mm
  EXPECT_EQ(only_note(job), "size 2000 x 200 x 100 mm, 0.314 kg");
}

TEST(PartNotes, ThicknessOfAFoilIsAskedAbout) {
  PartJob job = steel_link();
  for (Vector3d& vertex : job.mesh.vertices) vertex.z() *= 1e-3;
  EXPECT_EQ(only_note(job),
            "the part is 0.01 mm thick, less than a thousandth of its 200 mm: "
            "see that the unit of its thickness is right");
  for (Vector3d& vertex : job.mesh.vertices) vertex.z() *= 30.0;
  EXPECT_TRUE(part_notes(job).empty());
}

TEST(PartNotes, PlateThickerThanWideIsAskedAbout) {
  PartJob job = steel_link();
  for (Vector3d& vertex : job.mesh.vertices) vertex.z() *= 4.0;
  job.part.thickness = 0.04;  // beside a width of 20 mm
  EXPECT_TRUE(part_notes(job).empty());
  for (Vector3d& vertex : job.mesh.vertices) vertex.z() *= 2.5;
  job.part.thickness = 0.1;  // cm for mm
  EXPECT_EQ(only_note(job),
            "its thickness of 100 mm is 5 times its width of 20 mm: see that "
            "its unit is right");
  job.part.thickness.reset();  // a solid's mesh has been seen
  EXPECT_TRUE(part_notes(job).empty());
}

// Young's modulus [Pa], Poisson's ratio, density [kg/m³], yield strength [Pa].
TEST(PartNotes, MaterialsAreAskedAboutThatNobodyHas) {
  const part::Material sound[] = {
      {"diamond", 1050e9, 0.1, 3500.0, 2e9},
      {"beryllium", 303e9, 0.032, 1850.0, 240e6},
      {"lead", 16e9, 0.44, 11340.0, 5e6},
      {"PTFE", 0.5e9, 0.46, 2200.0, 12e6},
      {"polyethylene", 0.2e9, 0.45, 920.0, 10e6},
      {"rubber", 0.02e9, 0.4999, 1100.0, 15e6},
      {"maraging steel", 190e9, 0.3, 8000.0, 2.4e9},
      {"Invar", 140e9, 0.29, 8050.0, 280e6},
      {"grey iron", 100e9, 0.26, 7200.0, 200e6},
      {"tungsten", 400e9, 0.28, 19300.0, 750e6},
      {"magnesium", 45e9, 0.29, 1740.0, 200e6},
      {"spruce", 15e9, 0.3, 450.0, 50e6},
      {"foam", 0.02e9, 0.3, 45.0, 1e6},
      {"carbon fibre", 150e9, 0.0, 1600.0, 1.5e9},
  };
  for (const part::Material& material : sound) {
    PartJob job = steel_link();
    job.part.material = material;
    EXPECT_TRUE(part_notes(job).empty()) << material.name;
  }
  const part::Material wrong[] = {
      {"steel", 0.21e9, 0.3, 7850.0, 100e6},  // MPa for GPa
      {"aluminium", 0.07e9, 0.33, 2700.0, 60e6},
      {"steel", 210e9, 0.3, 78.5, 355e6},  // a hundredth
      {"steel", 210e9, 0.3, 785.0, 355e6},
      {"steel", 210e9, 0.3, 78500.0, 355e6},
      {"steel", 21e9, 0.3, 7850.0, 355e6},
      {"steel", 1100e9, 0.3, 7850.0, 355e6},
      {"brass", 10e9, 0.35, 8500.0, 300e6},    // yields at 3 %
      {"plastic", 0.6e9, 0.3, 1200.0, 355e6},  // yields at 59 %
      {"steel", 210e9, 0.03, 7850.0, 355e6},
      {"steel", 210e9, 0.0003, 7850.0, 355e6},
      {"steel", 210e9, -0.3, 7850.0, 355e6},
  };
  for (const part::Material& material : wrong) {
    PartJob job = steel_link();
    job.part.material = material;
    EXPECT_NE(only_note(job).find("see that"), std::string::npos)
        << material.youngs_modulus << ' ' << material.poissons_ratio;
  }
}

TEST(PartNotes, DampingOfNoLinkIsAskedAbout) {
  PartJob job = steel_link();
  job.part.damping = 0.3;
  EXPECT_TRUE(part_notes(job).empty());
  job.part.damping = 0.5;  // of one percent
  EXPECT_TRUE(only_note(job).starts_with("its damping is 0.5 of the critical"));
}

TEST(PartNotes, LoadsThatUseHardlyAnyStrengthAreAskedAbout) {
  EXPECT_TRUE(strength_notes(0.02).empty());
  ASSERT_EQ(strength_notes(1e-3).size(), 1u);
  EXPECT_NE(strength_notes(1e-3)[0].find("1000 times its strength"),
            std::string::npos);
  EXPECT_TRUE(strength_notes(0.0).empty());  // nothing stresses it
  EXPECT_TRUE(strength_notes(99.0).empty());
  ASSERT_EQ(strength_notes(432.0).size(), 1u);
  EXPECT_NE(strength_notes(432.0)[0].find("safety factor 432"),
            std::string::npos);
}

}  // namespace
}  // namespace clevis::assessment
