#include "report/machine/bearing_output.h"

#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "part/verdict.h"
#include "report/check/check_junit.h"
#include "report/check/check_table.h"
#include "report/check/result_json.h"
#include "report/compare/comparison.h"
#include "report/compare/result_reader.h"
#include "support/json_schema.h"
#include "support/source_dir.h"
#include "unit/report/sample_report.h"

namespace clevis::report {
namespace {

using nlohmann::json;
using part::Verdict;

BearingReport sample_bearing(part::Verdict verdict) {
  machine::BearingResult result;
  result.name = "pin, left";
  result.dynamic_rating = 1470.0;
  result.static_rating = 550.0;
  result.mean_load = 1118.0;
  result.peak_load = 1200.0;
  result.static_load = 1200.0;
  result.static_safety = 0.458;
  result.static_safety_wanted = 1.0;
  result.life = 2.27e6;
  result.life_cycles = 7e6;
  result.life_seconds = 7200.0;
  result.life_wanted = 3600.0;
  result.verdict = verdict;
  if (verdict != Verdict::kPass) result.why = "P0 too large";
  result.warnings = {{"B001", "P0 > C0"}, {"B004", "P > C/2"}};
  return {result, "C"};
}

CheckReport report_with(part::Verdict verdict) {
  CheckReport report = sample_report();
  report.bearings = {sample_bearing(verdict)};
  return report;
}

TEST(BearingOutput, ResultFitsThePublishedSchema) {
  std::ifstream file(support::source_dir() / "docs/result.schema.json");
  const json schema = json::parse(file);
  CheckReport report = report_with(Verdict::kFail);
  report.bearings.push_back(sample_bearing(Verdict::kPass));
  auto& idle = report.bearings[1].result;
  idle.life = idle.life_cycles = idle.life_seconds = idle.static_safety =
      idle.life_wanted = std::nullopt;
  const json written = json::parse(result_json(report));
  EXPECT_TRUE(test_support::schema_errors(written, schema).empty());
  EXPECT_EQ(written["bearings"][0]["life_h"], 2.0);
  EXPECT_EQ(written["bearings"][0]["life_wanted_h"], 1.0);
  EXPECT_TRUE(written["bearings"][1]["life_h"].is_null());
  EXPECT_FALSE(json::parse(result_json(sample_report())).contains("bearings"));
}

TEST(BearingOutput, AFailedBearingFailsTheCheck) {
  EXPECT_EQ(exit_code(report_with(Verdict::kPass)), ExitCode::kPass);
  EXPECT_EQ(exit_code(report_with(Verdict::kFail)), ExitCode::kLimitExceeded);
  EXPECT_EQ(exit_code(report_with(Verdict::kNotJudged)), ExitCode::kNotJudged);
}

TEST(BearingOutput, JunitTellsStaticSafetyAndLife) {
  const std::string failed = check_junit(report_with(Verdict::kFail));
  EXPECT_NE(failed.find("failures=\"1\" errors=\"0\""), std::string::npos);
  EXPECT_NE(failed.find("P0 1200 N, C0 550 N"), std::string::npos);
  EXPECT_NE(failed.find("L10 2 h, at least 1 h wanted"), std::string::npos);
  CheckReport open = report_with(Verdict::kNotJudged);
  open.bearings[0].result.static_safety = 1.5;
  EXPECT_NE(check_junit(open).find("failures=\"0\" errors=\"2\""),
            std::string::npos);
}

TEST(BearingOutput, TableAndCsvNameWarningsByCode) {
  const CheckReport report = report_with(Verdict::kFail);
  const std::string table = check_table(report, Colour::kNone);
  EXPECT_NE(table.find("B001: P0 > C0"), std::string::npos);
  EXPECT_NE(table.find("fail: P0 too large"), std::string::npos);
  const std::string csv = bearings_csv(report.bearings);
  EXPECT_EQ(csv.rfind("name,joint,kind,verdict,why,dynamic_rating_N", 0), 0u);
  EXPECT_NE(csv.find("\n\"pin, left\",C,ball,fail,"), std::string::npos);
  EXPECT_NE(csv.find(",B001 B004\n"), std::string::npos);
}

/// Rows that are a regression of the changed bearing against the sample's.
std::vector<std::string> moved_after(const BearingReport& changed) {
  const auto stored = [](const BearingReport& bearing) {
    CheckReport report = sample_report();
    report.bearings = {bearing};
    const TestFolder folder;
    std::ofstream(folder / "result.json") << result_json(report);
    return read_result(folder.path());
  };
  const Comparison comparison =
      compare(stored(changed), stored(sample_bearing(Verdict::kPass)), {});
  std::vector<std::string> moved;
  for (const ComparisonRow& row : comparison.rows) {
    if (is_regression(row)) moved.push_back(row.subject + ": " + row.quantity);
  }
  return moved;
}

TEST(BearingOutput, ComparisonSeesLoadLifeAndVerdict) {
  BearingReport bearing = sample_bearing(Verdict::kPass);
  EXPECT_TRUE(moved_after(bearing).empty());
  bearing.result.mean_load *= 1.0 + 1e-5;
  bearing.result.life_seconds = 7201.0;
  EXPECT_EQ(moved_after(bearing),
            (std::vector<std::string>{"bearing pin, left: bearing_life",
                                      "bearing pin, left: bearing_load"}));
  bearing = sample_bearing(Verdict::kPass);
  bearing.result.life_seconds = std::nullopt;
  EXPECT_EQ(moved_after(bearing).size(), 1u);
  bearing.result.name = "another";
  EXPECT_EQ(moved_after(bearing).size(), 2u);  // one missing, one new
}

}  // namespace
}  // namespace clevis::report
