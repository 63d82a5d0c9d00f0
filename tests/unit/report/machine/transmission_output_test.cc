#include "report/machine/transmission_output.h"

#include <fstream>
#include <numbers>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/messages/errors.h"
#include "report/check/result_json.h"
#include "report/compare/comparison.h"
#include "report/compare/result_reader.h"
#include "support/json_schema.h"
#include "support/source_dir.h"
#include "unit/report/sample_report.h"

namespace clevis::report {
namespace {

using namespace machine;
using nlohmann::json;

/// A turning stage on a sliding one, of 1e-4 rad/(N m) and 1e-8 m/N.
TransmissionReport screw() {
  TransmissionDefinition t;
  t.name = "screw, \"left\"";
  t.stages = {{"turns", 1000.0, true, {{"", GivenCompliance{1e-4, true}, ""}}},
              {"slides", 1.0, false, {{"", GivenCompliance{1e-8, false}, ""}}}};
  t.motor_inertia = 1e-4;
  t.load_inertia = 50.0;
  t.load = 100.0;
  t.errors = ErrorShares{1e-6, 2e-6, 3e-6, 10.0};
  return {"1.0", "drive", {analyse_transmission(t)}};
}

TEST(TransmissionOutput, KeysNameTheUnitsOfTheOutput) {
  const json document = json::parse(transmission_json(screw()));
  const json& t = document["transmissions"][0];
  EXPECT_NEAR(t["compliance_m_per_N"].get<double>(), 1.01e-8, 1e-22);
  EXPECT_EQ(t["elements"][0]["own_rad_per_N_m"], 1e-4);
  EXPECT_EQ(t["elements"][1]["own_m_per_N"], 1e-8);
  EXPECT_EQ(t["two_mass"]["motor_mass_kg"], 100.0);
  EXPECT_NEAR(t["error"]["compliance_m"].get<double>(), 1.01e-6, 1e-20);
  EXPECT_NEAR(t["error"]["worst_case_m"].get<double>(), 7.01e-6, 1e-19);
  EXPECT_NEAR(t["error"]["reversal_run_m"].get<double>(),
              t["error"]["reversal_m"].get<double>(), 1e-11);
}

TEST(TransmissionOutput, FitsThePublishedSchema) {
  std::ifstream file(support::source_dir() / "docs/transmission.schema.json");
  const json schema = json::parse(file);
  TransmissionReport report = screw();
  for (const bool turns : {false, true}) {
    report.transmissions[0].angular = turns;
    report.transmissions[0].chain = machine::ChainModel{{10.0}, {5.0, 7.0}};
    const auto errors = test_support::schema_errors(
        json::parse(transmission_json(report)), schema);
    EXPECT_TRUE(errors.empty()) << errors.front();
  }
  json document = json::parse(transmission_json(report));
  document["transmissions"][0]["two_mass"].erase("resonance_Hz");
  EXPECT_EQ(test_support::schema_errors(document, schema).size(), 1u);
}

/// Through the file, as a baseline goes.
StoredResult stored(const TransmissionReport& report) {
  const TestFolder folder;
  std::ofstream(folder / "transmission.json") << transmission_json(report);
  return read_result(folder / "transmission.json");
}

TEST(TransmissionOutput, ComparisonSeesElementsSumsAndFrequencies) {
  TransmissionReport report = screw();
  EXPECT_FALSE(is_regression(compare(stored(report), stored(screw()), {})));
  report.transmissions[0].elements[0].own *= 1.0 + 1e-8;
  report.transmissions[0].two_mass->resonance *= 1.0 + 1e-8;
  report.transmissions[0].chain = machine::ChainModel{{10.0}, {}};
  std::string moved;
  for (const auto& row : compare(stored(report), stored(screw()), {}).rows) {
    if (is_regression(row)) moved += row.subject + " " + row.quantity + "; ";
  }
  EXPECT_EQ(moved,
            "resonance of screw, \"left\" frequency; element screw, "
            "\"left\"/turns/given_1 compliance; chain's resonance of screw, "
            "\"left\", no. 1 ; ");
}

TEST(TransmissionOutput, ComparisonWithACheckIsRefused) {
  const TestFolder folder;
  std::ofstream(folder / "result.json") << result_json(sample_report());
  TransmissionReport report = screw();
  report.scene = sample_report().scene;
  EXPECT_THROW(compare(stored(report), read_result(folder.path()), {}), Error);
  EXPECT_THROW(compare(read_result(folder.path()), stored(report), {}), Error);
}

TEST(TransmissionOutput, TextShowsMicrometresOrArcMinutes) {
  TransmissionReport report = screw();
  const std::string text = transmission_text(report, Colour::kNone);
  EXPECT_NE(text.find("error of the output, um: control 1, kinematic 2, "
                      "backlash 3, compliance 1.01; worst case 7.01"),
            std::string::npos)
      << text;
  TransmissionResult& turning = report.transmissions[0];
  turning.angular = true;
  turning.error->shares.control = std::numbers::pi / 180.0 / 60.0;
  EXPECT_NE(transmission_text(report, Colour::kNone).find("arcmin: control 1,"),
            std::string::npos);
}

TEST(TransmissionOutput, CsvHasOneRowPerElement) {
  EXPECT_EQ(transmission_csv(screw()),
            "transmission,stage,element,type,formula,own,own_unit,ratio,"
            "on_output,on_output_unit\n"
            "\"screw, \"\"left\"\"\",turns,given_1,given,given,0.0001,"
            "rad/(N m),1000,1e-10,m/N\n"
            "\"screw, \"\"left\"\"\",slides,given_1,given,given,1e-08,m/N,1,"
            "1e-08,m/N\n");
}

}  // namespace
}  // namespace clevis::report
