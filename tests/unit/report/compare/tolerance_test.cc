#include "report/compare/tolerance.h"

#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "support/source_dir.h"

namespace clevis::report {
namespace {

TEST(Tolerance, ReadsEveryFormOfTheManual) {
  const auto percent = parse_tolerance("0.2%", "MPa");
  ASSERT_TRUE(percent);
  EXPECT_EQ(percent->treatment, Treatment::kCompare);
  EXPECT_DOUBLE_EQ(percent->relative, 2e-3);
  EXPECT_EQ(percent->absolute, 0.0);
  EXPECT_DOUBLE_EQ(parse_tolerance("1e-4 %", "N")->relative, 1e-6);
  EXPECT_DOUBLE_EQ(parse_tolerance("0.05 mm", "mm")->absolute, 0.05);
  const auto both = parse_tolerance("0.5 % + 0.01 MPa", "MPa");
  ASSERT_TRUE(both);
  EXPECT_DOUBLE_EQ(both->relative, 5e-3);
  EXPECT_DOUBLE_EQ(both->absolute, 0.01);
  EXPECT_EQ(parse_tolerance("note", "mm")->treatment, Treatment::kNote);
  EXPECT_EQ(parse_tolerance("off", "mm")->treatment, Treatment::kIgnore);
}

TEST(Tolerance, RefusesWhatWouldWidenOrMeanNothing) {
  for (const char* text : {"", "%", "-1 %", "nan", "inf", "1e999", "0.1 mm",
                           "0.1 % 0.2", "0.1 +", "x", "0.2 %%", "0.5"}) {
    EXPECT_FALSE(parse_tolerance(text, "MPa")) << text;
  }
}

TEST(Tolerance, TextReadsBack) {
  for (const ToleranceRule& rule : tolerance_rules()) {
    if (rule.tolerance.treatment != Treatment::kCompare) continue;
    const std::string written = text(rule.tolerance, rule.unit);
    if (written == "exact") continue;
    const auto back = parse_tolerance(written, rule.unit);
    ASSERT_TRUE(back) << written;
    EXPECT_DOUBLE_EQ(back->relative, rule.tolerance.relative);
    EXPECT_DOUBLE_EQ(back->absolute, rule.tolerance.absolute);
  }
}

TEST(Tolerance, UserReplacesOneAndLeavesTheOthers) {
  Tolerances tolerances;
  tolerances.set("peak_von_mises", "1 %", "U001", "--tolerance");
  EXPECT_DOUBLE_EQ(tolerances.of("peak_von_mises").relative, 0.01);
  EXPECT_DOUBLE_EQ(tolerances.of("deflection").relative, 2e-3);
}

TEST(Tolerance, MistakesAreExplained) {
  Tolerances tolerances;
  try {
    tolerances.set("peak_von_misses", "1 %", "U001", "--tolerance");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "U001");
    EXPECT_NE(error.remedy().find("peak_von_mises"), std::string::npos);
  }
  try {
    tolerances.set("deflection", "1 MPa", "I003", "baseline");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "I003");
    EXPECT_NE(error.remedy().find("0.01 mm"), std::string::npos);
  }
}

// The manual's table and the code hold the same defaults.
TEST(Tolerance, ManualListsEveryDefault) {
  std::ifstream file(support::source_dir() / "docs/results.md");
  std::string line;
  std::map<std::string, std::string, std::less<>> row_of;
  while (std::getline(file, line)) {
    if (!line.starts_with("| `")) continue;
    const std::string names = line.substr(0, line.find(" | "));
    for (const ToleranceRule& rule : tolerance_rules()) {
      const std::string name = fmt::format("`{}`", rule.quantity);
      if (names.find(name) != std::string::npos) {
        row_of[std::string(rule.quantity)] = line;
      }
    }
  }
  for (const ToleranceRule& rule : tolerance_rules()) {
    const auto row = row_of.find(rule.quantity);
    ASSERT_NE(row, row_of.end()) << rule.quantity;
    const bool noted = rule.tolerance.treatment == Treatment::kNote;
    const std::string wanted =
        noted ? "| noted" : "| " + text(rule.tolerance, rule.unit) + " |";
    EXPECT_NE(row->second.find(wanted), std::string::npos)
        << rule.quantity << ": " << wanted;
  }
}

}  // namespace
}  // namespace clevis::report
