#include "study/reference.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "unit/study/sample.h"

namespace clevis::study {
namespace {

TEST(StudyReference, GeometricSequenceIsExtrapolatedToItsLimit) {
  // 5 + 2 q^n with q = 0.3
  const std::array<double, 3> sequence = {5.0 + 2.0, 5.0 + 0.6, 5.0 + 0.18};
  const Reference reference = extrapolate(sequence);
  EXPECT_NEAR(reference.value, 5.0, 1e-14);
  EXPECT_GE(reference.uncertainty, 0.18 - 1e-14);
}

TEST(StudyReference, UnsteadySequenceKeepsItsLastValue) {
  EXPECT_EQ(extrapolate(std::array{1.0, 3.0, 2.0}).value, 2.0);
  EXPECT_EQ(extrapolate(std::array{1.0, 3.0, 2.0}).uncertainty, 0.5);
  EXPECT_EQ(extrapolate(std::array{1.0, 1.1, 1.2}).value, 1.2);
  EXPECT_EQ(extrapolate(std::array{4.0}).uncertainty, 4.0);
}

TEST(StudyReference, TakesTheFinestSeriesThatTellsItsRate) {
  PartStudy study = sample_study();
  study.runs.push_back(run_of("3-D, cells halved", "p = 3", 80e6, 5.0));
  study.runs.push_back(run_of("3-D, cells halved", "p = 4", 90e6, 9.0));
  study::Run missing = run_of("3-D, cells halved", "p = 5", 1.0, 1.0);
  missing.left_out = "F004: too large";
  study.runs.push_back(missing);
  const std::array<std::string, 2> series = {"3-D", "3-D, cells halved"};
  set_references(series, {}, study);
  EXPECT_EQ(study.reference_run, "3-D, p = 4");
  EXPECT_EQ(study.peak.value, 99.95e6);
  study.runs.push_back(run_of("3-D, cells halved", "p = 6", 90e6, 20.0));
  set_references(series, {}, study);
  EXPECT_EQ(study.reference_run, "3-D, cells halved, p = 6");
  const std::array<std::string, 2> short_ones = {"plane stress",
                                                 "CalculiX C3D20R"};
  set_references(short_ones, {}, study);
  EXPECT_EQ(study.reference_run, "CalculiX C3D20R, h/2");
}

TEST(StudyReference, PublishedValueOfAProbeStands) {
  PartStudy study = sample_study();
  study.probe_names = {"D stress_yy", "E stress_yy"};
  study.is_stress = {true, true};
  for (auto& run : study.runs) run.probes = {1.0, run.peak};
  const std::array<std::string, 1> series = {"3-D"};
  const std::array<std::optional<double>, 2> published = {92.7e6, std::nullopt};
  set_references(series, published, study);
  ASSERT_EQ(study.probes.size(), 2U);
  EXPECT_EQ(study.probes[0].value, 92.7e6);
  EXPECT_EQ(study.probes[0].uncertainty, 0.0);
  EXPECT_EQ(study.probes[1].value, 99.95e6);
}

}  // namespace
}  // namespace clevis::study
