#include "report/check/check_table.h"

#include <sstream>
#include <vector>

#include <gtest/gtest.h>

#include "part/verdict.h"
#include "report/text/text_table.h"
#include "report/text/units.h"
#include "unit/report/sample_report.h"

namespace clevis::report {
namespace {

using assessment::PeakVerdict;
using part::Verdict;

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

bool holds(const std::string& text, const std::string& piece) {
  return text.find(piece) != std::string::npos;
}

TEST(TextTable, CellsStandUnderTheirTitles) {
  TextTable table({{"name"}, {"n", Align::kRight}, {"last"}});
  table.add_row({{"µ"}, {"1"}, {"x"}});
  table.add_row({{"longer"}, {"100"}, {"y"}});
  table.add_note("note");
  EXPECT_EQ(table.text(Colour::kNone),
            "name      n  last\n"
            "µ         1  x\n"
            "longer  100  y\n"
            "    note\n");
}

TEST(TextTable, ColourDoesNotShiftColumns) {
  TextTable table({{"a", Align::kRight}, {"b"}});
  table.add_row({{"x", Tone::kBad}, {"y"}});
  table.add_row({{"xxx"}, {"z"}});
  EXPECT_EQ(table.text(Colour::kAnsi),
            "  a  b\n  \033[1;31mx\033[0m  y\nxxx  z\n");
}

TEST(TextTable, NamesCannotSteerTheTerminal) {
  TextTable table({{"a"}});
  table.add_row({{"\033[2J\n"}});
  table.add_note("\033]0;x\007");
  EXPECT_EQ(table.text(Colour::kNone), "a\n?[2J?\n    ?]0;x?\n");
}

TEST(CheckTable, PartTakesOneLineWithAllItsFigures) {
  CheckReport report = sample_report();
  report.parts.resize(1);
  report.parts[0].beam.reason.clear();
  report.parts[0].why.clear();
  report.parts[0].probes.clear();
  const auto lines = lines_of(check_table(report, Colour::kNone));
  ASSERT_EQ(lines.size(), 8u);
  EXPECT_EQ(lines[0], "landing gear (geometry/landing_gear/scene.toml)");
  EXPECT_EQ(lines[1],
            "mechanism: mobility 1, 0 redundant constraints, 201 instants, "
            "closure 2.0e-13 mm, power balance 3.0e-13");
  EXPECT_EQ(lines[4],
            "DCE     125.00  [124.50, 125.75]  bore_C (12.5, -3.0, 4.0)  "
            "t = 1.25 s  plane stress, p = 4   2.840    0.1250     100.0    "
            "1.250  pass     0.21");
  EXPECT_EQ(lines[5], "    deflection: 0.1250 [0.1240, 0.1270] mm");
  EXPECT_EQ(lines[7], "verdict: pass   3.10 s");
}

TEST(CheckTable, ReasonsStandBelowTheirPart) {
  CheckReport report = sample_report();
  report.parts[0].verdict = Verdict::kNotJudged;
  report.parts[0].why = "the peak grows without bound";
  report.parts[0].peak.verdict = PeakVerdict::kSingular;
  const auto lines = lines_of(check_table(report, Colour::kNone));
  EXPECT_EQ(lines[4].substr(0, 3), "DCE");
  EXPECT_EQ(lines[5], "    probe D: stress_yy = 5.5000 [5.4000, 5.6000] MPa");
  EXPECT_EQ(lines[6],
            "    probe T: displacement_x = 0.015000 [0.014000, 0.016000] mm");
  EXPECT_EQ(lines[7], "    deflection: 0.1250 [0.1240, 0.1270] mm");
  EXPECT_EQ(lines[8], "    peak: singular");
  EXPECT_EQ(lines[9], "    not judged: the peak grows without bound");
  EXPECT_EQ(lines[10], "    FE/beam: curved eye");
  EXPECT_EQ(lines[11].substr(0, 2), "BC");
}

TEST(CheckTable, EngineIsToldWhereItWasAskedForOrMayBeTheOther) {
  CheckReport report = sample_report();
  report.parts.resize(1);
  report.inputs.engine = "auto";
  auto& part = report.parts[0];
  part.engine = "own";
  part.engine_why = "cheaper";
  part.dofs = 99999;
  const auto told = [&] {
    return holds(check_table(report, Colour::kNone),
                 "engine " + part.engine + ": cheaper");
  };
  EXPECT_FALSE(told());
  part.dofs = 100000;
  EXPECT_TRUE(told());
  part.dofs = 10;
  part.engine = "dealii";
  EXPECT_TRUE(told());
  part.engine = "own";
  report.inputs.engine = "own";
  EXPECT_TRUE(told());
}

TEST(CheckTable, FailuresAndInterruptionAreTold) {
  CheckReport report = sample_report();
  report.failures.push_back(
      {"AB", Error("F003", "part AB", "residual 0.1", "Report the scene.")});
  report.complete = false;
  const std::string table = check_table(report, Colour::kNone);
  EXPECT_TRUE(holds(table,
                    "AB: not computed: part AB: residual 0.1 (F003) Report "
                    "the scene."));
  EXPECT_TRUE(holds(table, "verdict: not judged (interrupted"));
}

TEST(CheckTable, PlacesOfTinyPartsHaveDigits) {
  EXPECT_EQ(place_text({12.54e-3, -2.96e-3, -1e-9}), "(12.5, -3.0, 0.0)");
  EXPECT_EQ(place_text({0.123e-3, -0.04e-3, -1e-12}), "(0.123, -0.040, 0.000)");
  EXPECT_EQ(place_text({0.0123e-3, 0.0, 0.0}), "(0.0123, 0.0000, 0.0000)");
  EXPECT_EQ(place_text({0.0, 0.0, 0.0}), "(0.0, 0.0, 0.0)");
}

TEST(CheckTable, NoStressHasNoSafety) {
  CheckReport report = sample_report();
  report.parts[0].peak.value = 0.0;
  report.parts[0].peak_outside.reset();
  report.parts[0].safety_factor = 0.0;
  EXPECT_TRUE(holds(lines_of(check_table(report, Colour::kNone))[4],
                    "plane stress, p = 4       - "));
}

TEST(CheckTable, WhatBeamTheoryDoesNotSayIsADash) {
  CheckReport report = sample_report();
  report.parts.resize(1);
  report.parts[0].beam = {};
  const auto lines = lines_of(check_table(report, Colour::kNone));
  EXPECT_TRUE(holds(lines[4], "         -        -  pass"));
}

TEST(CheckTable, MiddlePlaneHasNoMinusSign) {
  CheckReport report = sample_report();
  report.parts[0].peak.at = {0.0125, -0.0, -1e-9};
  EXPECT_TRUE(holds(check_table(report, Colour::kNone), "(12.5, 0.0, 0.0)"));
}

TEST(CheckTable, ColourMarksVerdictsOnlyWhenAsked) {
  EXPECT_TRUE(holds(check_table(sample_report(), Colour::kAnsi),
                    "verdict: \033[32mpass\033[0m"));
  EXPECT_FALSE(holds(check_table(sample_report(), Colour::kNone), "\033"));
}

}  // namespace
}  // namespace clevis::report
