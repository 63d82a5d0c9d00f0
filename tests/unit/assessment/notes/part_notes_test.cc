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
            "the yield strength of steel is 0.355 MPa, outside 1 MPa to 5 GPa: "
            "see that its unit is right");
  job.part.material.yield_strength = 35.5e9;
  EXPECT_NE(only_note(job).find("3.55e+04 MPa"), std::string::npos);
  for (const double sound : {1e6, 5e9}) {
    job.part.material.yield_strength = sound;
    EXPECT_TRUE(part_notes(job).empty()) << sound;
  }
}

TEST(PartNotes, DeflectionLimitAsLargeAsThePartIsAskedAbout) {
  PartJob job = steel_link();
  job.part.limits.deflection = 0.1;
  EXPECT_TRUE(part_notes(job).empty());
  job.part.limits.deflection = 3.0;  // m for mm
  EXPECT_EQ(only_note(job),
            "the limit of deflection is 3000 mm, more than half of the part's "
            "size (201.2 mm): see that its unit is right");
  job.part.limits.deflection.reset();
  EXPECT_TRUE(part_notes(job).empty());
}

TEST(PartNotes, AccelerationAsOfMillimetresIsAskedAbout) {
  PartJob job = steel_link();
  job.part.cases.resize(1);
  job.part.cases[0].name = "drop";
  job.part.cases[0].acceleration.y() = 2000.0;
  EXPECT_TRUE(part_notes(job).empty());
  job.part.cases[0].acceleration.y() = 9810.0;
  EXPECT_EQ(only_note(job),
            "case drop: its acceleration minus gravity is 9810 m/s^2, 1000 "
            "times the earth's gravity: see that its unit is right");
}

}  // namespace
}  // namespace clevis::assessment
