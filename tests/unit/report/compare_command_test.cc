#include "app/results/compare_command.h"

#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "report/check/result_files.h"
#include "sample_report.h"

namespace clevis::report {
namespace {

/// Two folders with results of the sample, the result changeable.
class CompareCommand : public ::testing::Test {
 protected:
  void SetUp() override {
    CheckReport changed = sample_report();
    changed.parts[0].peak.value *= 1.005;
    write_result_files(changed, folder_ / "changed");
    write_result_files(sample_report(), folder_ / "baseline");
    options_.result = folder_ / "changed";
    options_.baseline = folder_ / "baseline/result.json";
  }

  ExitCode run() {
    testing::internal::CaptureStdout();
    try {
      const ExitCode code = app::compare_command(options_);
      output_ = testing::internal::GetCapturedStdout();
      return code;
    } catch (const Error& error) {
      testing::internal::GetCapturedStdout();
      output_ = error.code() + " " + error.place();
      return error.exit_code();
    }
  }

  /// Changes the baseline's JSON.
  template <typename Change>
  void edit_baseline(Change change) {
    nlohmann::json json = nlohmann::json::parse(content_of(options_.baseline));
    change(json);
    std::ofstream(options_.baseline) << json;
  }

  TestFolder folder_;
  app::CompareOptions options_;
  std::string output_;
};

TEST_F(CompareCommand, SameResultReturnsZero) {
  options_.result = folder_ / "baseline";
  EXPECT_EQ(run(), ExitCode::kPass);
}

TEST_F(CompareCommand, PlantedHalfPercentReturnsThreeAndWritesJunit) {
  options_.junit = folder_ / "ci/compare.xml";
  EXPECT_EQ(run(), ExitCode::kRegression);
  EXPECT_NE(output_.find("peak_von_mises"), std::string::npos);
  EXPECT_NE(content_of(options_.junit).find("failures=\"1\""),
            std::string::npos);
}

TEST_F(CompareCommand, JsonIsOneDocument) {
  options_.json = true;
  EXPECT_EQ(run(), ExitCode::kRegression);
  EXPECT_EQ(nlohmann::json::parse(output_)["moved"].size(), 1u);
}

TEST_F(CompareCommand, CommandLineWinsOverBaselineOverDefault) {
  edit_baseline([](nlohmann::json& json) {
    json["tolerances"] = {{"peak_von_mises", "1 %"}};
  });
  EXPECT_EQ(run(), ExitCode::kPass);
  options_.tolerances = {"peak_von_mises=0.4%"};
  EXPECT_EQ(run(), ExitCode::kRegression);
}

TEST_F(CompareCommand, BaselineNeedsNoSecondsAndMayHoldUnknownKeys) {
  options_.result = folder_ / "baseline";
  edit_baseline([](nlohmann::json& json) {
    json.erase("seconds");
    json["parts"][0].erase("seconds");
    json["comment"] = "accepted because the lug became thicker";
  });
  EXPECT_EQ(run(), ExitCode::kPass);
}

TEST_F(CompareCommand, OtherSchemaOrSceneReturnsTwo) {
  edit_baseline([](nlohmann::json& json) {
    json["scene"] = "antenna";
  });
  EXPECT_EQ(run(), ExitCode::kUsage);
  EXPECT_EQ(output_.substr(0, 4), "R002");
  edit_baseline([](nlohmann::json& json) {
    json["schema"] = 99;
  });
  EXPECT_EQ(run(), ExitCode::kUsage);
  EXPECT_EQ(output_.substr(0, 4), "R002");
}

TEST_F(CompareCommand, DamagedFilesNameTheirPlace) {
  const std::string file = options_.baseline.string();
  edit_baseline([](nlohmann::json& json) {
    json["parts"][1]["peak_von_mises"]["value_MPa"] = "125";
  });
  EXPECT_EQ(run(), ExitCode::kIo);
  EXPECT_EQ(output_, "I003 " + file + ":/parts/1/peak_von_mises/value_MPa");
  edit_baseline([](nlohmann::json& json) {
    json["parts"][0].erase("mass_kg");
  });
  EXPECT_EQ(run(), ExitCode::kIo);
  EXPECT_EQ(output_, "I003 " + file + ":/parts/0");
  edit_baseline([](nlohmann::json& json) {
    json = {1, 2};
  });
  EXPECT_EQ(run(), ExitCode::kIo);
  std::ofstream(options_.baseline) << "{\"schema\": 1,\n";
  EXPECT_EQ(run(), ExitCode::kIo);
  EXPECT_EQ(output_, "I003 " + file + ":2:1");
  options_.baseline = folder_ / "none.json";
  EXPECT_EQ(run(), ExitCode::kIo);
  EXPECT_EQ(output_.substr(0, 4), "I001");
}

TEST_F(CompareCommand, PartThatStandsTwiceIsRefused) {
  edit_baseline([](nlohmann::json& json) {
    json["parts"].push_back(json["parts"][0]);
  });
  EXPECT_EQ(run(), ExitCode::kIo);
}

TEST_F(CompareCommand, WrongTolerancesAreRefusedAtTheirSource) {
  options_.tolerances = {"peak_von_mises"};
  EXPECT_EQ(run(), ExitCode::kUsage);
  options_.tolerances = {"speed=1%"};
  EXPECT_EQ(run(), ExitCode::kUsage);
  options_.tolerances.clear();
  edit_baseline([](nlohmann::json& json) {
    json["tolerances"] = {{"deflection", "1 MPa"}};
  });
  EXPECT_EQ(run(), ExitCode::kIo);
  EXPECT_EQ(output_,
            "I003 " + options_.baseline.string() + ":/tolerances/deflection");
}

}  // namespace
}  // namespace clevis::report
