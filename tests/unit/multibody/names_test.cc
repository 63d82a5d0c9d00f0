#include "multibody/names.h"

#include <gtest/gtest.h>

namespace clevis::multibody {
namespace {

TEST(Names, KeepsWhatASceneTakes) {
  std::vector<std::string> told;
  Names names("link", {"ground"});
  EXPECT_EQ(names.add("upper_arm.2", told), "upper_arm.2");
  EXPECT_TRUE(told.empty());
}

TEST(Names, ChangesOthersAndTellsIt) {
  std::vector<std::string> told;
  Names names("link", {"ground"});
  EXPECT_EQ(names.add("a::b", told), "a__b");
  EXPECT_EQ(names.add("a b", told), "a_b");
  EXPECT_EQ(names.add("a_b", told), "a_b_2");
  EXPECT_EQ(names.add("ground", told), "ground_2");
  EXPECT_EQ(names.add("", told), "link");
  EXPECT_EQ(names.add("../x", told), "_._x");
  EXPECT_EQ(names.add("-x", told), "_x");
  EXPECT_EQ(names.add("$(touch \"ran\")", told), "__touch__ran__");
  EXPECT_EQ(names.add(std::string(500, 'x'), told).size(), 44U);
  ASSERT_EQ(told.size(), 9U);
  EXPECT_EQ(told[0], "link \"a::b\": called a__b");
}

TEST(OneLine, HoldsNoControlCharactersAndWholeOnesOfUtf8) {
  EXPECT_EQ(one_line("a\n\x1b[31mb\x7f"), "a??[31mb?");
  EXPECT_EQ(one_line("ab\xC3\xA9", 3), "ab");
  EXPECT_EQ(one_line("ab\xC3\xA9", 4), "ab\xC3\xA9");
  EXPECT_EQ(one_line("abcdef", 3), "abc");
}

TEST(TomlText, CannotBeLeft) {
  EXPECT_EQ(toml_text("a\"]\nb = \\"), "\"a\\\"] b = \\\\\"");
}

}  // namespace
}  // namespace clevis::multibody
