#include "study/output.h"

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "study/table.h"
#include "unit/study/sample.h"

namespace clevis::study {
namespace {

/// Cells of a line; commas inside quotes do not count.
std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> result(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == ',' && !quoted) {
      result.emplace_back();
    } else if (c != '"') {
      result.back() += c;
    }
  }
  return result;
}

PartStudy with_probe() {
  PartStudy study = sample_study();
  study.probe_names = {"D displacement_y"};
  study.is_stress = {false};
  study.probes = {{2e-3, 0.0}};
  for (auto& run : study.runs) run.probes = {2.02e-3};
  Run missing = run_of("3-D", "p = 5", 0.0, 0.0);
  missing.left_out = "F004: 9e9 \"dofs\", too many";
  study.runs.push_back(missing);
  study.runs[5].displacement_difference = 0.004;
  return study;
}

TEST(StudyOutput, CsvHasAValueInEveryColumnThatTheHeaderNames) {
  std::istringstream csv(study_csv(with_probe()));
  std::string line;
  std::getline(csv, line);
  const auto header = cells(line);
  const auto column = [&](const std::string& name) {
    const auto at = std::ranges::find(header, name);
    EXPECT_NE(at, header.end()) << name;
    return static_cast<std::size_t>(at - header.begin());
  };
  std::getline(csv, line);
  const auto first = cells(line);
  ASSERT_EQ(first.size(), header.size());
  EXPECT_EQ(first[column("series")], "plane stress");
  EXPECT_EQ(first[column("setting")], "p = 2");
  EXPECT_EQ(first[column("dofs")], "1000");
  EXPECT_EQ(first[column("seconds")], "0.02");
  EXPECT_EQ(first[column("cpu_seconds")], "0.01");
  EXPECT_EQ(first[column("memory_MB")], "50.0");
  EXPECT_EQ(first[column("peak_MPa")], "99.5");
  EXPECT_EQ(first[column("peak_error_percent")], "0.5");
  EXPECT_EQ(first[column("energy_mJ")], "2");
  EXPECT_EQ(first[column("energy_error_percent")], "0");
  EXPECT_EQ(first[column("D displacement_y mm")], "2.02");
  EXPECT_EQ(first[column("D displacement_y error percent")], "1");
  std::vector<std::string> rows;
  while (std::getline(csv, line)) rows.push_back(line);
  ASSERT_EQ(rows.size(), 7U);
  EXPECT_EQ(cells(rows[4])[column("displacement_difference_percent")], "0.4");
  EXPECT_EQ(cells(rows[6])[column("note")],
            "left out: F004: 9e9 dofs, too many");
}

TEST(StudyOutput, JsonHoldsReferenceAndRuns) {
  const Study study{"0.1", "scene", {with_probe()}, "CalculiX 2.20", true};
  const auto json = study_json(study);
  const auto& part = json.at("parts").at(0);
  EXPECT_EQ(json.at("schema"), 2);
  EXPECT_EQ(part.at("reference").at("peak").at("value_MPa"), 100.0);
  EXPECT_EQ(part.at("reference").at("probes").at(0).at("value_mm"), 2.0);
  EXPECT_EQ(part.at("runs").size(), 8U);
  EXPECT_DOUBLE_EQ(part.at("runs").at(0).at("peak_error"), 0.005);
  EXPECT_EQ(part.at("runs").at(7).at("left_out"),
            "F004: 9e9 \"dofs\", too many");
  EXPECT_FALSE(part.at("runs").at(7).contains("peak_MPa"));
}

TEST(StudyOutput, RunComesBackFromAWorkerAsItWas) {
  study::Run run = with_probe().runs[5];
  run.seconds = {1, 0, 2, 3, 4, 5, 0, 15};
  run.checked.emplace();
  run.checked->band_low = 1e6 / 3.0;
  run.checked->band_high = 2e6;
  const study::Run back = decode_run(encode(run));
  EXPECT_EQ(encode(back), encode(run));
  EXPECT_EQ(back.series, run.series);
  EXPECT_EQ(back.peak, run.peak);
  EXPECT_EQ(back.seconds.factor, 3.0);
  EXPECT_EQ(back.checked->band_low, 1e6 / 3.0);
  EXPECT_EQ(back.displacement_difference, 0.004);
}

TEST(StudyTable, ErrorThatCrossesZeroByChanceIsNotFast) {
  const PartStudy study = sample_study();
  const auto one_percent = fastest_within(study, 0.01, Program::kClevis);
  ASSERT_TRUE(one_percent);
  EXPECT_EQ(one_percent->series, "plane stress");
  EXPECT_EQ(one_percent->setting, "p = 2");
  const auto tenth = fastest_within(study, 0.001, Program::kClevis);
  ASSERT_TRUE(tenth);
  EXPECT_EQ(tenth->series + tenth->setting, "3-Dp = 4");
  EXPECT_EQ(fastest_within(study, 0.01, Program::kOther)->setting, "h/2");
  EXPECT_FALSE(fastest_within(study, 0.001, Program::kOther));
}

TEST(StudyTable, SaysWhatIsLeftOutAndThatCalculixIsMissing) {
  const Study study{"0.1",
                    "scene",
                    {with_probe()},
                    "not found: its series is left out",
                    true};
  const std::string text = study_table(study, report::Colour::kNone);
  EXPECT_NE(text.find("AB, 3-D, p = 5: left out, F004"), std::string::npos);
  EXPECT_NE(text.find("CalculiX: not found"), std::string::npos);
  EXPECT_EQ(text.find("interrupted"), std::string::npos);
}

}  // namespace
}  // namespace clevis::study
