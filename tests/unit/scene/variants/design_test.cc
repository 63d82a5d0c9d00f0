#include "scene/variants/design.h"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "scene/variants/read_vary.h"

namespace clevis::scene {
namespace {

std::vector<Variant> variants(const std::string& text) {
  const std::string file = "x.toml";
  const toml::table root = toml::parse(text, std::string_view(file));
  return variants_of(
      read_vary({Value(*root.get("vary"), "vary", file), "vary"}));
}

std::string refusal(const std::string& text) {
  try {
    variants(text);
  } catch (const Error& error) {
    return error.code() + " " + error.place();
  }
  return "accepted";
}

constexpr const char* kGrid = R"([vary]
design = "grid"
[[vary.quantity]]
path = "part.AB.thickness"
from = "5 mm"
to = "7 mm"
count = 3
[[vary.quantity]]
path = "part.AB.material"
values = ["steel", "d16t"]
)";

TEST(Design, GridVariesItsLastQuantityFastest) {
  const auto found = variants(kGrid);
  ASSERT_EQ(found.size(), 6u);
  std::string all;
  for (const Variant& variant : found) {
    all += variant.name + " " + variant.settings[0].value + " " +
           variant.settings[1].value + "\n";
  }
  EXPECT_EQ(all,
            "v001 5 mm steel\nv002 5 mm d16t\nv003 6 mm steel\n"
            "v004 6 mm d16t\nv005 7 mm steel\nv006 7 mm d16t\n");
  EXPECT_EQ(found[0].settings[1].path, "part.AB.material");
  EXPECT_EQ(found[0].settings[1].place, "x.toml:8:1");
}

TEST(Design, ValuesOfANarrowRangeStayApart) {
  std::string text = kGrid;
  text.replace(text.find("5 mm"), 4, "10.00001 mm");
  text.replace(text.find("7 mm"), 4, "10.00005 mm");
  const auto found = variants(text);
  ASSERT_EQ(found.size(), 6u);
  EXPECT_EQ(found[0].settings[0].value, "10.00001 mm");
  EXPECT_EQ(found[2].settings[0].value, "10.00003 mm");
  EXPECT_EQ(found[4].settings[0].value, "10.00005 mm");
}

std::string hypercube(int samples, int seed) {
  return "[vary]\ndesign = \"latin_hypercube\"\nsamples = " +
         std::to_string(samples) + "\nseed = " + std::to_string(seed) +
         "\n[[vary.quantity]]\npath = \"a\"\nfrom = \"0 mm\"\nto = \"50 mm\"\n"
         "[[vary.quantity]]\npath = \"b\"\nfrom = -1.0\nto = 1.0\n"
         "[[vary.quantity]]\npath = \"c\"\nvalues = [\"x\", \"y\"]\n";
}

// What makes a design a Latin hypercube, whatever the random numbers.
TEST(Design, HypercubeHasOneSampleInEachSliceOfEachRange) {
  constexpr int kSamples = 50;
  const auto found = variants(hypercube(kSamples, 7));
  ASSERT_EQ(found.size(), 50u);
  std::set<int> slices_a, slices_b;
  for (const Variant& variant : found) {
    const double a = std::atof(variant.settings[0].value.c_str()) / 50.0;
    const double b = (std::atof(variant.settings[1].value.c_str()) + 1.0) / 2.0;
    slices_a.insert(static_cast<int>(a * kSamples));
    slices_b.insert(static_cast<int>(b * kSamples));
    EXPECT_TRUE(variant.settings[0].value.ends_with(" mm"));
  }
  EXPECT_EQ(slices_a.size(), 50u);
  EXPECT_EQ(slices_b.size(), 50u);
  EXPECT_EQ(std::ranges::count(found, "x",
                               [](const Variant& v) {
                                 return v.settings[2].value;
                               }),
            25);
}

TEST(Design, HypercubeDependsOnItsSeedAlone) {
  const auto first = variants(hypercube(10, 7));
  const auto again = variants(hypercube(10, 7));
  const auto other = variants(hypercube(10, 8));
  for (std::size_t v = 0; v < first.size(); ++v) {
    EXPECT_EQ(first[v].settings, again[v].settings);
  }
  EXPECT_NE(first[0].settings[0].value, other[0].settings[0].value);
}

TEST(Design, RefusesRangesThatAreNone) {
  const auto with = [](const std::string& quantity) {
    return refusal(
        "[vary]\ndesign = \"grid\"\n[[vary.quantity]]\npath = \"a\"\n" +
        quantity);
  };
  EXPECT_EQ(with("values = [1]\n"), "accepted");
  EXPECT_EQ(with("values = []\n"), "S006 x.toml:5:10");
  EXPECT_EQ(with("from = \"5 mm\"\nto = \"6 cm\"\ncount = 2\n"),
            "S004 x.toml:6:6");
  EXPECT_EQ(with("from = \"thin\"\nto = \"6 mm\"\ncount = 2\n"),
            "S004 x.toml:5:8");
  EXPECT_EQ(with("from = 5\nto = 5.0\ncount = 2\n"), "S006 x.toml:6:6");
  EXPECT_EQ(with("from = 5\nto = 6\n"), "S003 x.toml:3:1");
  EXPECT_EQ(with("from = 5\nto = 6\ncount = 1\n"), "S006 x.toml:7:9");
  EXPECT_EQ(with("values = [1]\nfrom = 5\n"), "S010 x.toml:6:1");
  EXPECT_EQ(with("from = 0\nto = 1\ncount = 1000\n[[vary.quantity]]\npath = "
                 "\"b\"\nfrom = 0\nto = 1\ncount = 1000\n"),
            "S006 x.toml:1:1");
  EXPECT_EQ(refusal("[vary]\ndesign = \"grid\"\n"), "S003 x.toml:1:1");
  EXPECT_EQ(refusal("[vary]\ndesign = \"grid\"\nseed = 1\n[[vary.quantity]]\n"
                    "path = \"a\"\nvalues = [1]\n"),
            "S010 x.toml:3:1");
}

}  // namespace
}  // namespace clevis::scene
