#include "scene/variants/variant_list.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/messages/errors.h"
#include "scene/csv/csv_text.h"

namespace clevis::scene {
namespace {

namespace fs = std::filesystem;

/// Fields with their places, rows apart by |.
std::string parsed(const std::string& text) {
  std::string all;
  try {
    for (const auto& row : parse_csv(text, "v.csv")) {
      for (const CsvField& field : row) {
        all += "<" + field.text + ">" + field.place.substr(6);
      }
      all += "|";
    }
  } catch (const Error& error) {
    return error.code() + " " + error.place();
  }
  return all;
}

TEST(CsvText, FollowsRfc4180) {
  EXPECT_EQ(parsed("a,b\r\n1,2\r\n"), "<a>1:1<b>1:3|<1>2:1<2>2:3|");
  EXPECT_EQ(parsed("a,b\n1,2"), "<a>1:1<b>1:3|<1>2:1<2>2:3|");
  EXPECT_EQ(parsed("\"a,\"\"b\"\"\",c\n"), "<a,\"b\">1:1<c>1:11|");
  EXPECT_EQ(parsed("\"x\ny\",c\n1,2\n"), "<x\ny>1:1<c>2:4|<1>3:1<2>3:3|");
  EXPECT_EQ(parsed("\xef\xbb\xbf"
                   "a\n\n1\n"),
            "<a>1:1|<1>3:1|");
  EXPECT_EQ(parsed("a,b\n1,\n"), "<a>1:1<b>1:3|<1>2:1<>2:3|");
  EXPECT_EQ(parsed(""), "");
}

TEST(CsvText, RefusesWhatIsNot) {
  EXPECT_EQ(parsed("a,b\n1\n"), "S012 v.csv:2:1");
  EXPECT_EQ(parsed("a,\"b\n1,2\n"), "S012 v.csv:1:3");
  EXPECT_EQ(parsed("a\"b\n"), "S012 v.csv:1:2");
  EXPECT_EQ(parsed("\"a\"b\n"), "S012 v.csv:1:4");
  EXPECT_EQ(parsed("a\rb\n"), "S012 v.csv:1:2");
}

class VariantList : public ::testing::Test {
 protected:
  fs::path file_ = fs::temp_directory_path() /
                   ("variant_list_" + std::to_string(getpid()) + ".csv");
  void TearDown() override { fs::remove(file_); }

  std::vector<Variant> read(const std::string& text) const {
    std::ofstream(file_) << text;
    return read_variant_list(file_);
  }
  std::string refusal(const std::string& text) const {
    try {
      read(text);
    } catch (const Error& error) {
      const std::string place = error.place();
      return error.code() + place.substr(file_.string().size());
    }
    return "accepted";
  }
};

TEST_F(VariantList, PutsTheUnitOfTheHeaderBehindTheFields) {
  const auto found = read(
      "part.AB.thickness [mm],variant,part.AB.material,joint.B.at.AB[0]\n"
      "8,thick,steel,140 mm\n9.5,thicker,d16t,141 mm\n");
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].name, "thick");
  EXPECT_EQ(found[1].settings[0],
            (Setting{"part.AB.thickness", "9.5 mm", file_.string() + ":3:1"}));
  EXPECT_EQ(found[0].settings[1].value, "steel");
  EXPECT_EQ(found[0].settings[2].path, "joint.B.at.AB[0]");
}

TEST_F(VariantList, NumbersVariantsWithoutNames) {
  const auto found = read("a\n1\n2\n");
  EXPECT_EQ(found[0].name, "v001");
  EXPECT_EQ(found[1].name, "v002");
}

TEST_F(VariantList, RefusesTwinsGapsAndNamesThatAreNoFolders) {
  EXPECT_EQ(refusal("variant,a\nx,1\nx,2\n"), "S008:3:1");
  EXPECT_EQ(refusal("variant,a\n../x,1\n"), "S006:2:1");
  EXPECT_EQ(refusal("variant,a\nplan.json,1\n"), "S006:2:1");
  EXPECT_EQ(refusal("a,b\n1,\n"), "S012:2:3");
  EXPECT_EQ(refusal("a [mm],a [cm]\n1,2\n"), "S012:1:8");
  EXPECT_EQ(refusal("a b\n1\n"), "S007:1:1");
  EXPECT_EQ(refusal("a\n"), "S012:1:1");
  EXPECT_EQ(refusal(""), "S012:1:1");
}

}  // namespace
}  // namespace clevis::scene
