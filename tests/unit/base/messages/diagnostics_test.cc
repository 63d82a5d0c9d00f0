#include "base/messages/diagnostics.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "base/messages/errors.h"

namespace clevis {
namespace {

TEST(Diagnostics, AreSortedWithoutDuplicates) {
  const auto all = diagnostics();
  ASSERT_FALSE(all.empty());
  for (std::size_t i = 1; i < all.size(); ++i) {
    EXPECT_LT(all[i - 1].code, all[i].code);
  }
}

TEST(Diagnostics, EachSaysWhatItMeansAndFails) {
  for (const Diagnostic& entry : diagnostics()) {
    EXPECT_EQ(entry.code.size(), 4u);
    EXPECT_FALSE(entry.title.empty()) << entry.code;
    EXPECT_FALSE(entry.explanation.empty()) << entry.code;
    EXPECT_NE(entry.exit_code, ExitCode::kPass) << entry.code;
  }
}

TEST(Diagnostics, UnknownCodeIsInternalError) {
  EXPECT_EQ(find_diagnostic("S003").title, "missing key");
  EXPECT_EQ(find_diagnostic("Q999").code, "X001");
}

TEST(Error, CarriesCodePlaceProblemRemedyAndExitCode) {
  const Error error("M003", "part AB", "no bore_X", "Name it.");
  EXPECT_EQ(error.code(), "M003");
  EXPECT_EQ(error.place(), "part AB");
  EXPECT_EQ(error.problem(), "no bore_X");
  EXPECT_EQ(error.remedy(), "Name it.");
  EXPECT_EQ(error.exit_code(), ExitCode::kMeshInvalid);
  EXPECT_STREQ(error.what(), "part AB: no bore_X (M003)");
}

}  // namespace
}  // namespace clevis
