#include "report/summary/impact_output.h"

#include <gtest/gtest.h>

namespace clevis::report {
namespace {

NamedImpact blow(const char* force, double peak) {
  NamedImpact named{.force = force, .impact = {}};
  named.impact.peak_force = peak;
  return named;
}

TEST(ImpactOutput, TouchesWithoutForceAreCountedOnly) {
  const std::string text = impacts_text(
      {blow("ground", 800.0), blow("grazed", 0.0), blow("stop", 1e-3)},
      Colour::kNone);
  EXPECT_NE(text.find("ground"), std::string::npos);
  EXPECT_NE(text.find("stop"), std::string::npos);
  EXPECT_EQ(text.find("grazed"), std::string::npos);
  EXPECT_NE(text.find("2 hardest of 3 impacts"), std::string::npos);
}

TEST(ImpactOutput, AllAreShownWhereNoneHasForce) {
  const std::string text = impacts_text({blow("grazed", 0.0)}, Colour::kNone);
  EXPECT_NE(text.find("grazed"), std::string::npos);
  EXPECT_EQ(text.find("hardest"), std::string::npos);
}

}  // namespace
}  // namespace clevis::report
