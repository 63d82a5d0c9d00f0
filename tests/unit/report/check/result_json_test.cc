#include "report/check/result_json.h"

#include <cmath>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "part/verdict.h"
#include "report/check/result_files.h"
#include "support/json_schema.h"
#include "support/source_dir.h"
#include "unit/report/sample_report.h"

namespace clevis::report {
namespace {

using nlohmann::json;

json schema() {
  std::ifstream file(support::source_dir() / "docs/result.schema.json");
  return json::parse(file);
}

json written(const CheckReport& report) {
  return json::parse(result_json(report));
}

std::string all_errors(const json& document) {
  std::string text;
  for (const auto& error : test_support::schema_errors(document, schema())) {
    text += error + "\n";
  }
  return text;
}

CheckReport report_with_everything() {
  CheckReport report = sample_report();
  report.failures.push_back(
      {"AB", Error("F003", "part AB", "residual 1", "Report it.")});
  report.complete = false;
  report.parts[1].beam.buckling_safety.reset();
  assessment::PartResult& sharp = report.parts[1];
  sharp.peak.verdict = assessment::PeakVerdict::kSingular;
  sharp.peak_outside = sharp.peak;
  sharp.singular_zones = {
      {"notch at (1.0, 2.0) mm", 0.5445, {}, {1e-3, 2e-3, 0}, 1e-4, true},
      {"edge of root at (0.0, 0.0) mm", 0.7112, 0.7107, {}, 2e-4, false}};
  report.limits["BC"].exclude_singular_zones = true;
  return report;
}

TEST(ResultJson, WhatIsWrittenFitsThePublishedSchema) {
  EXPECT_EQ(all_errors(written(sample_report())), "");
  EXPECT_EQ(all_errors(written(report_with_everything())), "");
  CheckReport cases_only = sample_report();
  cases_only.mechanism.reset();
  EXPECT_EQ(all_errors(written(cases_only)), "");
}

TEST(ResultJson, SingularZonesAreListedInMillimetres) {
  const json part = written(report_with_everything())["parts"][1];
  const json& notch = part["singular_zones"][0];
  EXPECT_TRUE(notch["exponent_measured"].is_null());
  EXPECT_EQ(notch["at_mm"][1], 2.0);
  EXPECT_DOUBLE_EQ(notch["radius_mm"], 0.1);
  EXPECT_EQ(notch["governs"], true);
  EXPECT_EQ(part["singular_zones"][1]["exponent_measured"], 0.7107);
  EXPECT_EQ(part["peak_outside_singular_zones"]["value_MPa"], 125.0);
  EXPECT_EQ(part["limits"]["singular_zones"], "exclude");
}

// Otherwise the test above could not fail.
TEST(ResultJson, SchemaCatchesMissingUndeclaredAndWrongKeys) {
  const json good = written(sample_report());
  json bad = good;
  bad["parts"][1]["peak_von_mises"].erase("band_MPa");
  EXPECT_EQ(all_errors(bad), "/parts/1/peak_von_mises/band_MPa: is missing\n");
  bad = good;
  bad["parts"][0]["beam"]["extra"] = 1;
  EXPECT_EQ(all_errors(bad), "/parts/0/beam/extra: undeclared\n");
  bad = good;
  bad["mechanism"]["joints"][1]["at_s"] = "2 s";
  EXPECT_EQ(all_errors(bad),
            "/mechanism/joints/1/at_s: is not of type \"number\"\n");
  bad = good;
  bad["verdict"] = "perhaps";
  EXPECT_NE(all_errors(bad), "");
  bad = good;
  bad["parts"][0]["peak_von_mises"]["at_mm"].erase(2);
  EXPECT_NE(all_errors(bad), "");
}

// What docs/results.md promises, key by key, with the units of the names.
TEST(ResultJson, KeysOfTheContractHoldTheirUnits) {
  const json result = written(sample_report());
  EXPECT_EQ(result["schema"], 2);
  EXPECT_EQ(result["version"], "0.1.0");
  EXPECT_EQ(result["scene"], "landing gear");
  EXPECT_EQ(result["verdict"], "pass");
  EXPECT_EQ(result["seconds"]["total"], 3.1);
  const json& mechanism = result["mechanism"];
  EXPECT_EQ(mechanism["mobility"], 1);
  EXPECT_EQ(mechanism["redundant_constraints"], 0);
  EXPECT_EQ(mechanism["instants"], 201);
  EXPECT_DOUBLE_EQ(mechanism["max_closure_error_mm"], 2e-13);
  EXPECT_DOUBLE_EQ(mechanism["max_power_balance_error"], 3e-13);
  EXPECT_EQ(mechanism["joints"][0]["name"], "D");
  EXPECT_EQ(mechanism["joints"][0]["peak_force_N"], 2970.5);
  EXPECT_EQ(mechanism["joints"][0]["at_s"], 0.5);
  EXPECT_EQ(mechanism["drives"][0]["peak_effort_N"], 5029.0);
  EXPECT_EQ(mechanism["drives"][1]["peak_effort_Nm"], 12.5);
  const json& part = result["parts"][0];
  EXPECT_EQ(part["name"], "DCE");
  EXPECT_EQ(part["verdict"], "pass");
  EXPECT_EQ(part["model"], "plane stress, p = 4");
  EXPECT_EQ(part["dofs"], 4758);
  EXPECT_EQ(part["safety_factor"], 2.84);
  EXPECT_DOUBLE_EQ(part["deflection_mm"], 0.125);
  EXPECT_DOUBLE_EQ(part["deflection_band_mm"][0], 0.124);
  EXPECT_DOUBLE_EQ(part["deflection_band_mm"][1], 0.127);
  EXPECT_DOUBLE_EQ(part["peak_von_mises"]["errors_MPa"]["mesh"], 0.5);
  EXPECT_DOUBLE_EQ(part["peak_von_mises"]["errors_MPa"]["time"], 0.25);
  EXPECT_DOUBLE_EQ(part["strain_energy_mJ"], 6.65709);
  EXPECT_EQ(part["strain_energy_J"]["at_s"], 1.5);
  EXPECT_EQ(part["strain_energy_J"]["mean"], 2.5e-3);
  EXPECT_DOUBLE_EQ(part["limits"]["deflection_mm"], 0.5);
  EXPECT_TRUE(result["parts"][1]["limits"]["safety_factor"].is_null());
  EXPECT_EQ(part["self_checks"]["equilibrium"], 1e-12);
  EXPECT_EQ(part["self_checks"]["reported_peak_is_field_maximum"], true);
}

TEST(ResultJson, PeakBeamAndProbesHoldTheirUnits) {
  const json result = written(sample_report());
  const json& part = result["parts"][0];
  const json& peak = part["peak_von_mises"];
  EXPECT_DOUBLE_EQ(peak["value_MPa"], 125.0);
  EXPECT_DOUBLE_EQ(peak["band_MPa"][0], 124.5);
  EXPECT_DOUBLE_EQ(peak["band_MPa"][1], 125.75);
  EXPECT_EQ(peak["verdict"], "converged");
  EXPECT_DOUBLE_EQ(peak["at_mm"][0], 12.5);
  EXPECT_DOUBLE_EQ(peak["at_mm"][1], -3.0);
  EXPECT_DOUBLE_EQ(peak["at_mm"][2], 4.0);
  EXPECT_EQ(peak["instant_s"], 1.25);
  EXPECT_EQ(peak["case"], "t = 1.25 s");
  const json& beam = part["beam"];
  EXPECT_DOUBLE_EQ(beam["peak_stress_MPa"], 100.0);
  EXPECT_DOUBLE_EQ(beam["deflection_mm"], 0.11);
  EXPECT_EQ(beam["ratio_fe_to_beam"], 1.25);
  EXPECT_TRUE(beam.contains("impact_factor"));
  EXPECT_TRUE(beam.contains("impact_stress_MPa"));
  EXPECT_EQ(part["probes"][0]["quantity"], "stress_yy");
  EXPECT_DOUBLE_EQ(part["probes"][0]["value_MPa"], 5.5);
  EXPECT_DOUBLE_EQ(part["probes"][0]["band_MPa"][1], 5.6);
  EXPECT_DOUBLE_EQ(part["probes"][1]["value_mm"], 0.015);
}

// Beam theory without a formula, no plane face that holds the part …
TEST(ResultJson, WhatIsNotKnownIsNull) {
  CheckReport report = sample_report();
  report.parts[0].beam = {};
  report.parts[0].buckling.remark = "not computed: no memory";
  EXPECT_EQ(all_errors(written(report)), "");
  const json result = written(report);
  const json& part = result["parts"][0];
  EXPECT_TRUE(part["beam"]["peak_stress_MPa"].is_null());
  EXPECT_TRUE(part["beam"]["ratio_fe_to_beam"].is_null());
  EXPECT_TRUE(part["support_section"].is_null());
  EXPECT_TRUE(part["vibration"].is_null());
  EXPECT_TRUE(part["strain_energy_error_percent"].is_null());
  EXPECT_TRUE(part["peak_von_mises"]["degree_nearby"].is_null());
  EXPECT_FALSE(part.contains("peak_outside_singular_zones"));
  EXPECT_TRUE(part["buckling"]["factor"].is_null());
  EXPECT_TRUE(part["buckling"]["band"].is_null());
  EXPECT_EQ(part["buckling"]["is_lower_bound"], false);
  EXPECT_TRUE(result["parts"][1]["buckling"].is_null());
}

TEST(ResultJson, BucklingHasItsBand) {
  CheckReport report = sample_report();
  report.parts[0].buckling = {
      .factor = 2.5, .band_low = 2.25, .band_high = 2.75};
  report.parts[1].buckling = {.factor = 100, .band_low = 100, .band_high = 100};
  EXPECT_EQ(all_errors(written(report)), "");
  const json result = written(report);
  EXPECT_EQ(result["parts"][0]["buckling"]["band"], json({2.25, 2.75}));
  EXPECT_EQ(result["parts"][0]["buckling"]["is_lower_bound"], false);
  EXPECT_EQ(result["parts"][1]["buckling"]["is_lower_bound"], true);
}

TEST(ResultJson, NonFiniteResultIsRefusedByPartAndKey) {
  CheckReport report = sample_report();
  report.parts[1].deflection = std::nan("");
  const TestFolder folder;
  try {
    write_result_files(report, folder.path());
    FAIL() << "NaN was written";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "F003");
    EXPECT_EQ(error.place(), "part BC");
    EXPECT_NE(error.problem().find("deflection_mm"), std::string::npos);
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(CheckReport, VerdictIsTheWorstOfTheParts) {
  using part::Verdict;
  CheckReport report = sample_report();
  EXPECT_EQ(exit_code(report), ExitCode::kPass);
  report.complete = false;
  EXPECT_EQ(exit_code(report), ExitCode::kNotJudged);
  report.complete = true;
  report.parts[0].verdict = Verdict::kNotJudged;
  EXPECT_EQ(overall_verdict(report), Verdict::kNotJudged);
  EXPECT_EQ(exit_code(report), ExitCode::kNotJudged);
  report.parts[1].verdict = Verdict::kFail;
  EXPECT_EQ(overall_verdict(report), Verdict::kFail);
  EXPECT_EQ(exit_code(report), ExitCode::kLimitExceeded);
  report.failures.push_back({"AB", Error("M005", "AB", "folded", "Mesh it.")});
  EXPECT_EQ(exit_code(report), ExitCode::kMeshInvalid);
  report.parts.clear();
  report.failures.clear();
  EXPECT_EQ(overall_verdict(report), Verdict::kNotJudged);
}

TEST(ResultFiles, AllAreWritten) {
  const TestFolder folder;
  write_result_files(sample_report(), folder / "out");
  for (const char* name : {"out/parts.csv", "out/junit.xml"}) {
    EXPECT_GT(content_of(folder / name).size(), 100u) << name;
  }
  EXPECT_EQ(content_of(folder / "out/result.json"),
            result_json(sample_report()));
}

// A folder in the place of junit.xml stops the writing half-way.
TEST(ResultFiles, NoResultStaysBesideFilesOfAnotherRun) {
  const TestFolder folder;
  write_result_files(sample_report(), folder.path());
  std::filesystem::remove(folder / "junit.xml");
  std::filesystem::create_directories(folder / "junit.xml/x");
  EXPECT_THROW(write_result_files(sample_report(), folder.path()), Error);
  EXPECT_FALSE(std::filesystem::exists(folder / "result.json"));
}

}  // namespace
}  // namespace clevis::report
