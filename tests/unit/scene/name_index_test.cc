#include "scene/text/name_index.h"

#include <gtest/gtest.h>

#include "scene/text/suggestion.h"

namespace clevis::scene {
namespace {

TEST(Suggestion, NamesTheNearestAndAllKnown) {
  EXPECT_EQ(suggestion("lenght", {"width", "length"}),
            "Did you mean \"length\"? Known: width, length.");
  EXPECT_EQ(suggestion("CYLINDER", {"cylinder"}),
            "Did you mean \"cylinder\"? Known: cylinder.");
}

TEST(Suggestion, DoesNotGuessWhenNothingIsNear) {
  EXPECT_EQ(suggestion("zzz", {"width", "length"}), "Known: width, length.");
  EXPECT_EQ(suggestion("x", {}), "None is defined.");
}

class NameIndexTest : public ::testing::Test {
 protected:
  toml::value<int64_t> node_{1};
  std::string file_ = "x.toml";
  Value where_{node_, "drive.joint", file_};
  NameIndex names_{"joint"};
};

TEST_F(NameIndexTest, CountsInTheOrderOfTheFile) {
  EXPECT_EQ(names_.add("D", where_), 0);
  EXPECT_EQ(names_.add("C", where_), 1);
  EXPECT_EQ(names_.find("D", where_), 0);
  EXPECT_EQ(names_.find("C", where_), 1);
}

TEST_F(NameIndexTest, RefusesTwinsAndStrangers) {
  names_.add("D", where_);
  try {
    names_.add("D", where_);
    FAIL() << "took a twin";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "S008");
  }
  try {
    names_.find("d", where_);
    FAIL() << "found a stranger";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "S007");
    EXPECT_EQ(error.problem(), "drive.joint names no joint: \"d\"");
    EXPECT_EQ(error.remedy(), "Did you mean \"D\"? Known: D.");
  }
}

}  // namespace
}  // namespace clevis::scene
