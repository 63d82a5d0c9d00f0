#include "report/check/check_junit.h"

#include <gtest/gtest.h>

#include "part/verdict.h"
#include "report/text/junit.h"
#include "unit/report/sample_report.h"

namespace clevis::report {
namespace {

using assessment::PeakVerdict;
using part::Verdict;

/// The line of one test case.
std::string line_of(const std::string& xml, const std::string& part,
                    const std::string& name) {
  const std::string start =
      "<testcase classname=\"clevis." + part + "\" name=\"" + name + "\"";
  const std::size_t at = xml.find(start);
  return at == std::string::npos ? "" : xml.substr(at, xml.find('\n', at) - at);
}

bool holds(const std::string& text, const std::string& piece) {
  return text.find(piece) != std::string::npos;
}

CheckReport report_of(part::Verdict verdict) {
  CheckReport report = sample_report();
  report.parts.resize(1);
  report.parts[0].verdict = verdict;
  return report;
}

TEST(CheckJunit, PassingPartHasFourCasesWithNumbers) {
  const std::string xml = check_junit(report_of(Verdict::kPass));
  EXPECT_TRUE(holds(xml,
                    "name=\"landing gear\" tests=\"4\" failures=\"0\" "
                    "errors=\"0\" skipped=\"1\" time=\"0.210\""));
  EXPECT_TRUE(holds(line_of(xml, "DCE", "convergence"),
                    "125 MPa, band [124.5, 125.75] MPa at bore_C: converged"));
  EXPECT_TRUE(holds(line_of(xml, "DCE", "safety factor"), "2.84"));
  EXPECT_TRUE(holds(line_of(xml, "DCE", "deflection"), "0.125 mm"));
}

TEST(CheckJunit, ExceededLimitIsAFailureAndTheKeptOneIsNot) {
  CheckReport report = report_of(Verdict::kFail);
  report.parts[0].safety_factor = 1.25;
  report.parts[0].why = "too weak";
  const std::string xml = check_junit(report);
  EXPECT_TRUE(holds(xml, "tests=\"4\" failures=\"1\" errors=\"0\""));
  const std::string failed = line_of(xml, "DCE", "safety factor");
  EXPECT_TRUE(holds(failed, "<failure"));
  EXPECT_TRUE(holds(failed, "1.25, at least 1.5 wanted; too weak"));
  const std::string kept = line_of(xml, "DCE", "deflection");
  EXPECT_FALSE(holds(kept, "<failure"));
  EXPECT_FALSE(holds(kept, "too weak"));
}

TEST(CheckJunit, SafetyOfAPartThatVibratesIsNotThatOfThePeakAtRest) {
  CheckReport report = report_of(Verdict::kPass);
  report.parts[0].vibration.governs = true;
  EXPECT_TRUE(holds(line_of(check_junit(report), "DCE", "safety factor"),
                    "2.84 as it vibrates, at least 1.5 wanted"));
}

TEST(CheckJunit, DeflectionAboveItsLimitIsAFailure) {
  CheckReport report = report_of(Verdict::kFail);
  report.parts[0].deflection = 0.6e-3;
  report.parts[0].deflection_low = 0.59e-3;
  report.parts[0].deflection_high = 0.61e-3;
  const std::string failed = line_of(check_junit(report), "DCE", "deflection");
  EXPECT_TRUE(holds(failed, "<failure"));
  EXPECT_TRUE(holds(failed, "0.6 mm, band [0.59, 0.61] mm, at most 0.5 mm"));
}

TEST(CheckJunit, UnsettledPeakIsAnErrorEverywhere) {
  CheckReport report = report_of(Verdict::kNotJudged);
  report.parts[0].peak.verdict = PeakVerdict::kSingular;
  const std::string xml = check_junit(report);
  EXPECT_TRUE(holds(xml, "failures=\"0\" errors=\"3\""));
  EXPECT_TRUE(holds(line_of(xml, "DCE", "convergence"), "singular</error>"));
}

// A band wider than the tolerance may decide all the same.
TEST(CheckJunit, WideBandThatPassesIsNoError) {
  CheckReport report = report_of(Verdict::kPass);
  report.parts[0].peak.verdict = PeakVerdict::kNotConverged;
  EXPECT_TRUE(holds(check_junit(report), "failures=\"0\" errors=\"0\""));
  report.parts[0].verdict = Verdict::kNotJudged;
  EXPECT_TRUE(holds(check_junit(report), "failures=\"0\" errors=\"3\""));
}

TEST(CheckJunit, AbsentLimitIsSkipped) {
  CheckReport report = report_of(Verdict::kPass);
  report.limits.clear();
  EXPECT_TRUE(holds(check_junit(report), "errors=\"0\" skipped=\"3\""));
}

// The verdict may rest on something that the three cases do not show.
TEST(CheckJunit, NeverLooksBetterThanTheVerdict) {
  CheckReport report = report_of(Verdict::kFail);
  report.parts[0].why = "buckling";
  std::string xml = check_junit(report);
  EXPECT_TRUE(holds(line_of(xml, "DCE", "verdict"), "<failure"));
  report = report_of(Verdict::kNotJudged);
  report.limits.clear();
  xml = check_junit(report);
  EXPECT_TRUE(holds(line_of(xml, "DCE", "verdict"), "<error"));
}

TEST(CheckJunit, FailedAndMissingPartsAreErrors) {
  CheckReport report = report_of(Verdict::kPass);
  report.failures.push_back(
      {"AB", Error("F003", "part AB", "residual 0.1", "Report the scene.")});
  report.complete = false;
  const std::string xml = check_junit(report);
  EXPECT_TRUE(holds(xml, "tests=\"6\" failures=\"0\" errors=\"2\""));
  EXPECT_TRUE(holds(line_of(xml, "AB", "computation"), "residual 0.1"));
}

TEST(Junit, TextIsEscapedAndNothingIsMalformed) {
  const std::string xml =
      junit_xml("<s>&\"", {{"a'b", "<script>", JunitStatus::kFailure,
                            "x < 1 & \"y\" \x01 \xff ]]>", 0.5}});
  EXPECT_TRUE(holds(xml, "name=\"&lt;s&gt;&amp;&quot;\""));
  EXPECT_TRUE(holds(xml, "name=\"&lt;script&gt;\""));
  EXPECT_TRUE(holds(xml, "x &lt; 1 &amp; &quot;y&quot; ? \xef\xbf\xbd ]]&gt;"));
  EXPECT_TRUE(holds(xml, "classname=\"a&apos;b\""));
}

}  // namespace
}  // namespace clevis::report
