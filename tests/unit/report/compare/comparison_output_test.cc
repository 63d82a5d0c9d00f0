#include "report/compare/comparison_output.h"

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "unit/report/compare/sample_comparison.h"

namespace clevis::report {
namespace {

TEST(ComparisonOutput, TellsQuantityValuesChangeAndTolerance) {
  CheckReport changed = sample_report();
  changed.parts[0].peak.value *= 1.005;
  const Comparison comparison = compare_with_sample(changed);
  const std::string table = comparison_table(comparison, Colour::kNone);
  EXPECT_NE(
      table.find("part DCE  peak_von_mises [MPa]       125  125.625  +0.5 %  "
                 "0.2 % + 1e-06 MPa  moved\n"),
      std::string::npos)
      << table;
  EXPECT_NE(table.find("1 of 61 quantities moved: regression (R001)"),
            std::string::npos);
  const std::string xml = comparison_junit(comparison);
  EXPECT_NE(xml.find("tests=\"61\" failures=\"1\" errors=\"0\""),
            std::string::npos);
}

TEST(ComparisonOutput, SaysHowCloseAPassWas) {
  CheckReport changed = sample_report();
  changed.parts[1].safety_factor *= 1.001;  // half of its 0.2 %
  const std::string table =
      comparison_table(compare_with_sample(changed), Colour::kNone);
  EXPECT_NE(table.find("61 quantities within their tolerances, the largest "
                       "change takes 50 % of its own"),
            std::string::npos)
      << table;
}

TEST(ComparisonOutput, JsonHoldsWhatMoved) {
  CheckReport changed = sample_report();
  changed.parts[1].peak.at.x() += 1e-3;
  changed.parts.push_back(sample_part("AB"));
  const auto json =
      nlohmann::json::parse(comparison_json(compare_with_sample(changed)));
  EXPECT_EQ(json["verdict"], "regression");
  EXPECT_EQ(json["moved"][0]["of"], "part BC");
  EXPECT_EQ(json["moved"][0]["quantity"], "peak_position");
  EXPECT_EQ(json["moved"][0]["regression"], false);
  EXPECT_DOUBLE_EQ(json["moved"][0]["result"][0], 13.5);
  EXPECT_EQ(json["moved"][1]["of"], "part AB");
  EXPECT_EQ(json["moved"][1]["outcome"], "new");
}

}  // namespace
}  // namespace clevis::report
