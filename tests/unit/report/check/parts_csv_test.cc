#include "report/check/parts_csv.h"

#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "unit/report/sample_report.h"

namespace clevis::report {
namespace {

/// Rows of an RFC 4180 text, written from the RFC's grammar.
std::vector<std::vector<std::string>> parse(const std::string& csv) {
  std::vector<std::vector<std::string>> rows(1, {""});
  bool quoted = false;
  for (std::size_t i = 0; i < csv.size(); ++i) {
    const char c = csv[i];
    if (quoted && c == '"' && i + 1 < csv.size() && csv[i + 1] == '"') {
      rows.back().back() += csv[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && c == ',') {
      rows.back().emplace_back();
    } else if (!quoted && c == '\r' && csv.substr(i, 2) == "\r\n") {
      rows.push_back({""});
      ++i;
    } else {
      rows.back().back() += c;
    }
  }
  rows.pop_back();  // every row ends with CRLF
  return rows;
}

std::map<std::string, std::string> row_by_title(const CheckReport& report,
                                                std::size_t row) {
  const auto rows = parse(parts_csv(report));
  std::map<std::string, std::string> cells;
  for (std::size_t i = 0; i < rows[0].size(); ++i) {
    cells[rows[0][i]] = rows.at(row).at(i);
  }
  return cells;
}

TEST(PartsCsv, ColumnsHoldTheirUnits) {
  const auto row = row_by_title(sample_report(), 2);
  EXPECT_EQ(row.at("part"), "BC");
  EXPECT_EQ(row.at("verdict"), "pass");
  EXPECT_EQ(row.at("model"), "plane stress, p = 4");
  EXPECT_EQ(row.at("mass[kg]"), "0.75");
  EXPECT_DOUBLE_EQ(std::stod(row.at("peak_von_mises[MPa]")), 125.0);
  EXPECT_DOUBLE_EQ(std::stod(row.at("band_low[MPa]")), 124.5);
  EXPECT_DOUBLE_EQ(std::stod(row.at("band_high[MPa]")), 125.75);
  EXPECT_DOUBLE_EQ(std::stod(row.at("peak_x[mm]")), 12.5);
  EXPECT_DOUBLE_EQ(std::stod(row.at("peak_y[mm]")), -3.0);
  EXPECT_DOUBLE_EQ(std::stod(row.at("peak_z[mm]")), 4.0);
  EXPECT_EQ(row.at("peak_instant[s]"), "1.25");
  EXPECT_EQ(row.at("safety_factor[1]"), "2.84");
  EXPECT_DOUBLE_EQ(std::stod(row.at("deflection[mm]")), 0.125);
  EXPECT_DOUBLE_EQ(std::stod(row.at("deflection_low[mm]")), 0.124);
  EXPECT_DOUBLE_EQ(std::stod(row.at("deflection_high[mm]")), 0.127);
  EXPECT_DOUBLE_EQ(std::stod(row.at("time_error[MPa]")), 0.25);
  EXPECT_DOUBLE_EQ(std::stod(row.at("strain_energy[mJ]")), 6.65709);
  EXPECT_EQ(row.at("strain_energy_instant[s]"), "1.5");
  EXPECT_EQ(row.at("mean_strain_energy[J]"), "0.0025");
  EXPECT_DOUBLE_EQ(std::stod(row.at("beam_stress[MPa]")), 100.0);
  EXPECT_DOUBLE_EQ(std::stod(row.at("beam_deflection[mm]")), 0.11);
  EXPECT_EQ(row.at("ratio_fe_to_beam[1]"), "1.25");
}

// A part may fail by any of these: its row must tell.
TEST(PartsCsv, WhatDecidesTheVerdictStandsInTheRow) {
  CheckReport report = sample_report();
  assessment::PartResult& part = report.parts[0];
  part.peak_outside = part.peak;
  part.peak_outside->value = 90e6;
  part.held = assessment::SupportStress{
      .value = 80e6, .band_low = 79e6, .band_high = 82e6, .section = "root"};
  part.buckling.factor = 1.25;
  part.buckling.band_low = 1.2;
  part.buckling.band_high = 1.5;
  part.vibration.ratio = 1.5;
  part.vibration.governs = true;
  part.vibration.peak = 160e6;
  part.impacts.resize(2);
  part.impacts[0].name = "soft";
  part.impacts[0].stress = 10e6;
  part.impacts[0].safety_factor = 30.0;
  part.impacts[1].name = "hard";
  part.impacts[1].stress = 100e6;
  part.impacts[1].safety_factor = 3.0;
  const auto row = row_by_title(report, 1);
  EXPECT_EQ(row.at("outside_von_mises[MPa]"), "90");
  EXPECT_EQ(row.at("section"), "root");
  EXPECT_EQ(row.at("section_stress[MPa]"), "80");
  EXPECT_EQ(row.at("section_high[MPa]"), "82");
  EXPECT_EQ(row.at("buckling_factor[1]"), "1.25");
  EXPECT_EQ(row.at("buckling_low[1]"), "1.2");
  EXPECT_EQ(row.at("vibration_ratio[1]"), "1.5");
  EXPECT_EQ(row.at("vibration_von_mises[MPa]"), "160");
  EXPECT_EQ(row.at("impact"), "hard");
  EXPECT_EQ(row.at("impact_von_mises[MPa]"), "100");
  EXPECT_EQ(row.at("impact_safety_factor[1]"), "3");
}

TEST(PartsCsv, WhatIsNotKnownIsEmpty) {
  const auto row = row_by_title(sample_report(), 1);
  for (const char* title :
       {"outside_von_mises[MPa]", "section_stress[MPa]", "buckling_factor[1]",
        "buckling_low[1]", "vibration_ratio[1]", "impact_von_mises[MPa]"}) {
    EXPECT_EQ(row.at(title), "") << title;
  }
}

TEST(PartsCsv, CommasQuotesAndLineBreaksSurvive) {
  CheckReport report = sample_report();
  report.parts[0].why = "limit \"1,5\"\r\nexceeded";
  EXPECT_EQ(row_by_title(report, 1).at("why"), report.parts[0].why);
  EXPECT_EQ(row_by_title(report, 2).at("why"), report.parts[1].why);
}

TEST(PartsCsv, NumbersReadBackToTheSameBits) {
  CheckReport report = sample_report();
  report.parts[0].mass = 1.0 / 3.0;
  EXPECT_EQ(std::stod(row_by_title(report, 1).at("mass[kg]")), 1.0 / 3.0);
}

TEST(PartsCsv, OneRowPerPart) {
  EXPECT_EQ(parse(parts_csv(sample_report())).size(), 3u);
}

}  // namespace
}  // namespace clevis::report
