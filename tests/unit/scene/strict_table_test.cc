#include "scene/text/strict_table.h"

#include <functional>

#include <gtest/gtest.h>

namespace clevis::scene {
namespace {

/// Reads a text as the root table of a scene.
class StrictTableTest : public ::testing::Test {
 protected:
  StrictTable read(std::string_view text, std::string_view path = "") {
    root_ = toml::parse(text);
    return {Value(root_, "scene", file_), path};
  }

  /// "code place" of the refusal that an action ends in.
  static std::string refusal(const std::function<void()>& action) {
    try {
      action();
    } catch (const Error& error) {
      return error.code() + " " + error.place();
    }
    return "accepted";
  }

  toml::table root_;
  std::string file_ = "x.toml";
};

TEST_F(StrictTableTest, RefusesTheFirstUnknownKeyOfTheFile) {
  EXPECT_EQ(refusal([&] {
              read("schema = 1\n  zebra = 1\napple = 1\n");
            }),
            "S002 x.toml:2:3");
}

TEST_F(StrictTableTest, MissingKeyIsRefusedAtTheTable) {
  auto table = read("[world]\n[simulation]\ninstants = 3\n");
  EXPECT_EQ(refusal([&] {
              table.table("simulation")["duration"];
            }),
            "S003 x.toml:2:1");
  EXPECT_EQ(table.table("simulation")["instants"].integer(2, 5), 3);
}

TEST_F(StrictTableTest, FinishRefusesWhatNobodyRead) {
  auto table = read("schema = 1\nname = \"x\"\n");
  table["schema"];
  EXPECT_EQ(refusal([&] {
              table.finish("here");
            }),
            "S010 x.toml:2:1");
  table.find("name");
  table.find("world");  // absent: nothing to refuse
  EXPECT_EQ(refusal([&] {
              table.finish("here");
            }),
            "accepted");
}

TEST_F(StrictTableTest, ArraysOfTablesNeedTwoBrackets) {
  EXPECT_EQ(read("[[body]]\n[[body]]\n").tables("body").size(), 2u);
  EXPECT_EQ(read("").tables("body").size(), 0u);
  auto table = read("[body]\nname = \"x\"\n");
  EXPECT_EQ(refusal([&] {
              table.tables("body");
            }),
            "S005 x.toml:1:1");
}

TEST_F(StrictTableTest, NumbersMustBeNumbersInTheirRange) {
  const auto number = [&](const char* text) {
    auto table = read(std::string("peak_stress = ") + text, "accuracy");
    return refusal([&] {
      table["peak_stress"].number(-1.0, 0.5);
    });
  };
  EXPECT_EQ(number("-1"), "accepted");
  EXPECT_EQ(number("0.5"), "accepted");
  EXPECT_EQ(number("0.5001"), "S006 x.toml:1:15");
  EXPECT_EQ(number("-1.1"), "S006 x.toml:1:15");
  EXPECT_EQ(number("nan"), "S006 x.toml:1:15");
  EXPECT_EQ(number("inf"), "S006 x.toml:1:15");
  EXPECT_EQ(number("\"0.3\""), "S005 x.toml:1:15");
  EXPECT_EQ(number("true"), "S005 x.toml:1:15");
  EXPECT_EQ(number("1979-05-27"), "S005 x.toml:1:15");
}

TEST_F(StrictTableTest, IntegersMustBeIntegers) {
  const auto integer = [&](const char* text) {
    auto table = read(std::string("instants = ") + text, "simulation");
    return refusal([&] {
      table["instants"].integer(2, 10);
    });
  };
  EXPECT_EQ(integer("2"), "accepted");
  EXPECT_EQ(integer("10"), "accepted");
  EXPECT_EQ(integer("1"), "S006 x.toml:1:12");
  EXPECT_EQ(integer("9223372036854775807"), "S006 x.toml:1:12");
  EXPECT_EQ(integer("3.0"), "S005 x.toml:1:12");
}

TEST_F(StrictTableTest, QuantitiesNeedTextsWithUnits) {
  const auto quantity = [&](const char* text) {
    auto table = read(std::string("duration = ") + text, "simulation");
    return refusal([&] {
      table["duration"].positive(Dimension::kTime);
    });
  };
  EXPECT_EQ(quantity("\"2 s\""), "accepted");
  EXPECT_EQ(quantity("2"), "S004 x.toml:1:12");
  EXPECT_EQ(quantity("2.5"), "S004 x.toml:1:12");
  EXPECT_EQ(quantity("\"2\""), "S004 x.toml:1:12");
  EXPECT_EQ(quantity("\"2 m\""), "S004 x.toml:1:12");
  EXPECT_EQ(quantity("\"0 s\""), "S006 x.toml:1:12");
  EXPECT_EQ(quantity("\"-2 s\""), "S006 x.toml:1:12");
  EXPECT_EQ(quantity("[\"2 s\"]"), "S005 x.toml:1:12");
}

TEST_F(StrictTableTest, NamesMayBecomeFileNames) {
  const auto name = [&](const std::string& text) {
    auto table = read("name = '" + text + "'");
    return refusal([&] {
      table["name"].name();
    });
  };
  EXPECT_EQ(name("FE-1_b.2"), "accepted");
  EXPECT_EQ(name(std::string(64, 'a')), "accepted");
  for (const std::string& text :
       {std::string(), std::string(65, 'a'), std::string("a b"),
        std::string("a/b"), std::string(".."), std::string("-rf"),
        std::string("\xC3\xA4")}) {
    EXPECT_EQ(name(text), "S006 x.toml:1:8") << text;
  }
}

TEST_F(StrictTableTest, TitlesAreShortAndPrintable) {
  const auto title = [&](const std::string& text) {
    auto table = read("name = \"" + text + "\"");
    return refusal([&] {
      table["name"].title();
    });
  };
  EXPECT_EQ(title("ground on the wheel, left"), "accepted");
  EXPECT_EQ(title(std::string(64, 'a')), "accepted");
  EXPECT_EQ(title(std::string(65, 'a')), "S006 x.toml:1:8");
  EXPECT_EQ(title(""), "S006 x.toml:1:8");
  EXPECT_EQ(title("a\\u001b[2J"), "S006 x.toml:1:8");
}

TEST_F(StrictTableTest, EntriesKeepTheOrderOfTheFile) {
  auto table = read("[material]\nz = 1\na = 2\nm = 3\n");
  std::string order;
  for (const auto& [key, value] : table["material"].entries()) order += key;
  EXPECT_EQ(order, "zam");
}

}  // namespace
}  // namespace clevis::scene
