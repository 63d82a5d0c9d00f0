#include "scene/variants/apply_settings.h"

#include <optional>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "scene/text/value.h"

namespace clevis::scene {
namespace {

constexpr const char* kScene = R"(
schema = 1
[material.steel]
density = "7850 kg/m^3"
[[part]]
name = "AB"
thickness = "5 mm"
pins = { A = "bore_A" }
[[part]]
name = "A.2"
thickness = "6 mm"
[[joint]]
name = "B"
at = { AB = ["140 mm", "0 mm", "0 mm"] }
[[drive]]
joint = "B"
to = "260 mm"
[[drive]]
joint = "C"
coordinate = "angle"
[[drive]]
joint = "C"
coordinate = "distance"
)";

class ApplySettings : public ::testing::Test {
 protected:
  toml::table scene_ = toml::parse(kScene, std::string_view("x.toml"));

  void set(const std::string& text) {
    apply_settings({parse_setting(text, "--set 1")}, scene_);
  }
  /// "code place" and the remedy of what the setting is refused for.
  std::string refusal(const std::string& text) {
    try {
      set(text);
    } catch (const Error& error) {
      return error.code() + " " + error.place() + ": " + error.remedy();
    }
    return "accepted";
  }
  std::string place(const char* path) {
    return place_of("x.toml", scene_.at_path(path).node()->source());
  }
};

TEST_F(ApplySettings, ReplacesAValueAndLeavesTheOthers) {
  set("part.AB.thickness=8 mm");
  EXPECT_EQ(*scene_.at_path("part[0].thickness").value<std::string>(), "8 mm");
  EXPECT_EQ(place("part[0].thickness"), "--set 1");
  EXPECT_EQ(*scene_.at_path("part[1].thickness").value<std::string>(), "6 mm");
  EXPECT_EQ(place("part[1].thickness"), "x.toml:11:13");
}

TEST_F(ApplySettings, FindsEntriesByNameByJointAndByNumber) {
  set("part.\"A.2\".thickness=9 mm");
  EXPECT_EQ(*scene_.at_path("part[1].thickness").value<std::string>(), "9 mm");
  set("drive.B.to=\"100 mm\"");
  EXPECT_EQ(*scene_.at_path("drive[0].to").value<std::string>(), "100 mm");
  set("drive[2].coordinate=angle");
  EXPECT_EQ(*scene_.at_path("drive[2].coordinate").value<std::string>(),
            "angle");
  set("joint.B.at.AB[1]=1 mm");
  EXPECT_EQ(*scene_.at_path("joint[0].at.AB[1]").value<std::string>(), "1 mm");
  EXPECT_EQ(scene_.at_path("joint[0].at.AB").as_array()->size(), 3u);
  EXPECT_EQ(place("joint[0].at.AB[1]"), "--set 1");
  EXPECT_EQ(place("joint[0].at.AB[2]"), "x.toml:14:32");
}

TEST_F(ApplySettings, AddsKeysAndTheTablesAboveThem) {
  set("part.AB.limits.safety_factor=1.5");
  EXPECT_EQ(*scene_.at_path("part[0].limits.safety_factor").value<double>(),
            1.5);
  EXPECT_EQ(place("part[0].limits"), "--set 1");
  set("accuracy.peak_stress=5 %");
  EXPECT_EQ(*scene_.at_path("accuracy.peak_stress").value<std::string>(),
            "5 %");
}

TEST_F(ApplySettings, TakesTomlAsTomlAndTheRestAsText) {
  set("joint.B.at.AB=[\"1 mm\", \"2 mm\", \"3 mm\"]");
  EXPECT_EQ(*scene_.at_path("joint[0].at.AB[2]").value<std::string>(), "3 mm");
  set("part.AB.name=\"12\"");
  EXPECT_TRUE(scene_.at_path("part[0].name").is_string());
  set("schema=2");
  EXPECT_TRUE(scene_.at_path("schema").is_integer());
  set("material.steel.density=a \\ \"b\"");
  EXPECT_EQ(*scene_.at_path("material.steel.density").value<std::string>(),
            "a \\ \"b\"");
}

TEST_F(ApplySettings, RefusesWhatIsNotThere) {
  const auto begins = [&](const char* setting, const std::string& expected) {
    const std::string found = refusal(setting);
    EXPECT_EQ(found.substr(0, expected.size()), expected) << setting;
  };
  begins("part.AC.thickness=5 mm", "S007 --set 1: Did you mean \"AB\"?");
  begins("part[2].thickness=5 mm", "S007 --set 1: Numbers count from 0.");
  begins("drive.C.to=1 mm",
         "S008 --set 1: Take one by its number, e.g. drive[1]");
  begins("part.AB.thickness.x=1", "S005 --set 1");
  begins("schema[0]=1", "S005 --set 1");
  begins("material.stel.density=1 kg/m^3",
         "S007 --set 1: Did you mean \"steel\"?");
  begins("bearing.B.bore=5 mm", "S007 --set 1");
  begins("part..x=1", "S007 --set 1");
  begins("part.AB thickness=1", "S007 --set 1");
  begins("part.AB.thickness", "U001 --set 1");
  begins("=5", "U001 --set 1");
  begins("part.AB.thickness=", "U001 --set 1");
  begins("part.AB.thickness=5\nmm", "U001 --set 1");
}

// However its path is spelled, and where a whole table would undo it.
TEST_F(ApplySettings, RefusesTheSameValueTwice) {
  for (const char* again :
       {"part.\"AB\".thickness", "part[0].thickness", "part.AB"}) {
    toml::table scene = scene_;
    const std::vector<Setting> settings{
        {"part.AB.thickness", "5 mm", "--set 1"},
        {"schema", "1", "--set 2"},
        {again, "6 mm", "--set 3"}};
    try {
      apply_settings(settings, scene);
      FAIL() << again;
    } catch (const Error& error) {
      EXPECT_EQ(error.code() + " " + error.place(), "S010 --set 3");
      EXPECT_NE(error.problem().find("by --set 1"), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace clevis::scene
