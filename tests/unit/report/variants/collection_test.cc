#include "report/variants/collection.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/messages/errors.h"
#include "report/check/check_report.h"
#include "report/check/result_json.h"
#include "report/text/atomic_file.h"
#include "report/variants/collection_csv.h"
#include "report/variants/collection_figure.h"
#include "report/variants/collection_table.h"
#include "report/variants/plan_file.h"
#include "report/variants/variant_reader.h"
#include "unit/report/sample_report.h"

namespace clevis::report {
namespace {

namespace fs = std::filesystem;
using part::Verdict;

Variant variant(const std::string& name, const std::string& size, double mass,
                double peak, Verdict verdict) {
  Variant result;
  result.name = name;
  result.settings = {{"part.AB.thickness", size}};
  result.verdict = verdict;
  VariantPart part;
  part.name = "AB";
  part.verdict = verdict;
  part.mass = mass;
  part.peak = {peak, 0.98 * peak, 1.02 * peak};
  part.safety_factor = 355e6 / peak;
  part.safety_wanted = 1.5;
  part.deflection = {1e-4, 0.9e-4, 1.1e-4};
  result.parts = {part};
  return result;
}

Variant missing(const std::string& name, std::optional<ExitCode> refused) {
  Variant result;
  result.name = name;
  result.settings = {{"part.AB.thickness", "1 mm"}};
  result.missing = "R003 there is no result";
  result.refused = refused;
  return result;
}

Collection sample() {
  return {"a link",
          {variant("thin", "4 mm", 0.1, 300e6, Verdict::kFail),
           variant("thick", "8 mm", 0.2, 150e6, Verdict::kPass),
           variant("middle", "6 mm", 0.15, 200e6, Verdict::kPass),
           variant("light", "2 mm", 0.05, 230e6, Verdict::kNotJudged)}};
}

TEST(Collection, LightestIsOfThoseThatPass) {
  EXPECT_EQ(sample().lightest()->name, "middle");
  Collection none{"x", {missing("a", {})}};
  EXPECT_EQ(none.lightest(), nullptr);
}

TEST(Collection, ExitCodeIsThatOfACheckWithVariantsForParts) {
  Collection collection = sample();
  EXPECT_EQ(exit_code(collection), ExitCode::kLimitExceeded);
  collection.variants.erase(collection.variants.begin());
  EXPECT_EQ(exit_code(collection), ExitCode::kNotJudged);
  collection.variants.pop_back();
  EXPECT_EQ(exit_code(collection), ExitCode::kPass);
  collection.variants.push_back(missing("a", {}));
  EXPECT_EQ(exit_code(collection), ExitCode::kNotJudged);
  collection.variants.push_back(missing("b", ExitCode::kMeshInvalid));
  collection.variants.push_back(missing("c", ExitCode::kIo));
  EXPECT_EQ(exit_code(collection), ExitCode::kMeshInvalid);
  EXPECT_EQ(exit_code(Collection{}), ExitCode::kNotJudged);
}

TEST(Collection, TableNamesWhatIsMissing) {
  Collection collection = sample();
  collection.variants.push_back(missing("gone", {}));
  const std::string table = collection_table(collection, Colour::kNone);
  EXPECT_NE(table.find("5 variants: 2 pass, 1 fail, 1 not judged, 1 without a "
                       "result"),
            std::string::npos)
      << table;
  EXPECT_NE(table.find("R003 there is no result"), std::string::npos);
  EXPECT_NE(table.find("part.AB.thickness = 6 mm"), std::string::npos);
}

TEST(Collection, CsvHasTheSameFieldsInEveryRow) {
  Collection collection = sample();
  collection.variants.push_back(missing("gone", {}));
  const std::string csv = collection_csv(collection);
  EXPECT_TRUE(csv.starts_with(
      "variant,part.AB.thickness,verdict,missing,mass_kg,governing_part,"
      "peak_MPa,"));
  EXPECT_NE(csv.find("\nthin,4 mm,fail,,0.1,AB,300,294,306,1.18333333,0.1,"
                     "fail,0.1,300,294,306,1.18333333,0.1,0.09,0.11\n"),
            std::string::npos)
      << csv;
  std::size_t commas = 0;
  std::size_t start = 0;
  while (start < csv.size()) {
    const std::size_t end = csv.find('\n', start);
    const auto line = csv.substr(start, end - start);
    const auto here = static_cast<std::size_t>(std::ranges::count(line, ','));
    if (start == 0) commas = here;
    EXPECT_EQ(here, commas) << line;
    start = end + 1;
  }
}

TEST(Collection, FigureHasADotAndABandPerResult) {
  Collection collection = sample();
  collection.variants.push_back(missing("gone", {}));
  const PlotFigure figure = collection_figure(collection);
  ASSERT_EQ(figure.panels.size(), 1u);
  const PlotPanel& panel = figure.panels[0];
  EXPECT_EQ(panel.x_label, "part.AB.thickness, mm");
  std::size_t dots = 0;
  for (const PlotSeries& series : panel.series) {
    dots += series.points.size();
    for (const PlotPoint& point : series.points) {
      EXPECT_NEAR(point.low, 0.98 * point.y, 1e-9);
      EXPECT_NEAR(point.high, 1.02 * point.y, 1e-9);
    }
  }
  EXPECT_EQ(dots, 4u);
  ASSERT_TRUE(panel.limit.has_value());
  EXPECT_NEAR(*panel.limit, 355.0 / 1.5, 1e-9);
}

class CollectionFolder : public ::testing::Test {
 protected:
  fs::path folder_ =
      fs::temp_directory_path() / ("collection_" + std::to_string(getpid()));
  Plan plan_;

  void SetUp() override {
    CheckInputs inputs;
    inputs.settings = {{"b", "8 mm"}, {"a", "x"}};
    inputs.scene = "0123456789abcdef";
    inputs.tolerance = 0.05;
    inputs.model = inputs.engine = "auto";
    inputs.parts = {"AB"};
    inputs.meshes = {{"given", "0011223344556677"}};
    plan_ = {sample_report().version, "a link", "scene.toml", {{"v1", inputs}}};
    write_file(folder_ / kPlanFile, plan_json(plan_));
  }
  void TearDown() override { fs::remove_all(folder_); }

  Variant read() const { return read_collection(folder_).variants.at(0); }
};

TEST_F(CollectionFolder, PlanIsReadBackAsWritten) {
  const Plan plan = read_plan(folder_);
  ASSERT_EQ(plan.variants.size(), 1u);
  EXPECT_EQ(plan.variants[0].inputs, plan_.variants[0].inputs);
  EXPECT_EQ(plan.scene, "a link");
  EXPECT_EQ(plan.version, plan_.version);
}

TEST_F(CollectionFolder, TakesResultsOfItsInputsOnly) {
  EXPECT_EQ(read().missing, "R003 there is no result");
  CheckReport report = sample_report();
  report.failures.clear();
  report.inputs = plan_.variants[0].inputs;
  report.inputs.meshes.emplace_back("AB", "fedcba9876543210");  // as it is made
  write_file(folder_ / "v1/result.json", result_json(report));
  const Variant known = read();
  EXPECT_EQ(known.missing, "");
  EXPECT_EQ(known.parts.size(), report.parts.size());
  EXPECT_EQ(known.parts[0].name, report.parts[0].name);
  EXPECT_NEAR(known.parts[0].peak.value, report.parts[0].peak.value, 1e-3);

  // What was refused since was of other inputs.
  write_file(folder_ / "v1/error.json",
             R"({"error": {"code": "S004", "place": "scene.toml:1:1", )"
             R"("problem": "no number", "exit_code": 10}})");
  EXPECT_EQ(read().missing, "");
  fs::remove(folder_ / "v1/result.json");
  EXPECT_EQ(read().missing, "S004 scene.toml:1:1: no number");
  fs::remove(folder_ / "v1/error.json");

  for (auto* planned : {&report.version, &report.inputs.meshes[0].second}) {
    const std::string as_planned = std::exchange(*planned, "another");
    write_file(folder_ / "v1/result.json", result_json(report));
    EXPECT_NE(read().missing.find(planned == &report.version ? "another clevis"
                                                             : "other inputs"),
              std::string::npos);
    *planned = as_planned;
  }

  report.inputs.settings[0].second = "9 mm";
  write_file(folder_ / "v1/result.json", result_json(report));
  EXPECT_NE(read().missing.find("other inputs"), std::string::npos);

  report.inputs = plan_.variants[0].inputs;
  report.complete = false;
  write_file(folder_ / "v1/result.json", result_json(report));
  EXPECT_NE(read().missing.find("interrupted"), std::string::npos);

  write_file(folder_ / "v1/result.json", "{");
  EXPECT_EQ(read().missing.substr(0, 4), "I003");
  EXPECT_EQ(read().refused, ExitCode::kIo);
}

}  // namespace
}  // namespace clevis::report
