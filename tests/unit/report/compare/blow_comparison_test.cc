// Blows and vibration of a part against their baseline.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "unit/report/compare/sample_comparison.h"

namespace clevis::report {
namespace {

using Part = assessment::PartResult;

/// A part with a blow, and with vibration.
void strike(Part& part) {
  assessment::ImpactResult blow;
  blow.name = "blow";
  blow.source = "given";
  blow.mass = 0.2;
  blow.speed = 1.0;
  blow.force = 8.0;
  blow.stiffness = 1e7;
  blow.part_mass = 0.04;
  blow.first_period = 5e-4;
  blow.load_duration = 7e-4;
  blow.rise_time = 3e-4;
  blow.peak_force = 400.0;
  blow.dynamic_factor = 1.2;
  blow.stress = 180e6;
  blow.band_low = 178e6;
  blow.band_high = 183e6;
  blow.deflection = 0.2e-3;
  blow.deflection_low = 0.19e-3;
  blow.deflection_high = 0.21e-3;
  blow.later_stress = blow.later_deflection = 1.05;
  blow.free_vibration_stress = 1.2;
  blow.free_vibration_deflection = 1.2;
  blow.safety_factor = 2.0;
  blow.root = assessment::SupportStress{
      .value = 200e6, .band_low = 198e6, .band_high = 203e6, .section = "root"};
  blow.refinement.stress = {170e6, 175e6, 180e6};
  blow.refinement.fronts = {4e-6, 2e-6, 1e-6};
  blow.refinement.deflection = {2e-4, 2e-4, 2e-4};
  blow.rows = {{.model = assessment::ImpactModel::kBeamCorrected,
                .nominal = 190e6,
                .face = 0.2e-3},
               {.model = assessment::ImpactModel::kElementsInTime,
                .scheme = "29 shapes",
                .degree = 4,
                .stress = 180e6,
                .nominal = 200e6,
                .face = 0.19e-3,
                .deflection = 0.2e-3}};
  part.impacts = {blow};
  part.vibration = {.ratio = 1.3,
                    .peak = 160e6,
                    .band_low = 155e6,
                    .band_high = 165e6,
                    .model = "3-D, p = 3"};
}

// Every number of a blow and of its models, each planted alone; a number that
// appears or goes too.
TEST(Comparison, EveryNumberOfABlowIsHeld) {
  CheckReport sample = sample_report();
  strike(sample.parts[0]);
  const StoredResult baseline = stored(sample);
  EXPECT_EQ(regressions(compare(stored(sample), baseline, {})), "");
  using Blow = assessment::ImpactResult;
  const auto after = [&](auto change) {
    CheckReport report = sample;
    change(report.parts[0]);
    return regressions(compare(stored(report), baseline, {}));
  };
  const std::string of = "impact DCE/blow ";
  const std::vector<std::pair<double Blow::*, std::string>> plain = {
      {&Blow::mass, "striker_mass"},
      {&Blow::speed, "striker_speed"},
      {&Blow::force, "striker_force"},
      {&Blow::first_period, "first_period"},
      {&Blow::load_duration, "contact_duration"},
      {&Blow::peak_force, "contact_force"},
      {&Blow::dynamic_factor, "dynamic_factor"},
      {&Blow::stress, "peak_von_mises"},
      {&Blow::band_low, "band_low"},
      {&Blow::band_high, "band_high"},
      {&Blow::deflection, "deflection"},
      {&Blow::deflection_low, "deflection_low"},
      {&Blow::deflection_high, "deflection_high"},
      {&Blow::safety_factor, "safety_factor"}};
  for (const auto& [member, quantity] : plain) {
    const auto times = [&, member = member](double factor) {
      return after([&](Part& part) {
        part.impacts[0].*member *= factor;
      });
    };
    EXPECT_EQ(times(1.003), of + quantity);
    EXPECT_EQ(times(1.0 + 1e-7), "");
  }
  const std::vector<std::pair<double Blow::*, std::string>> loose = {
      {&Blow::rise_time, "contact_rise"},
      {&Blow::later_stress, "later_stress"},
      {&Blow::later_deflection, "later_deflection"}};
  for (const auto& [member, quantity] : loose) {
    EXPECT_EQ(after([&, member = member](Part& part) {
                part.impacts[0].*member *= 1.02;
              }),
              of + quantity);
  }
  EXPECT_EQ(after([](Part& part) {
              part.impacts[0].root->value *= 1.003;
            }),
            of + "section_stress");
  EXPECT_EQ(after([](Part& part) {
              part.impacts[0].refinement.settles = false;
            }),
            of + "settles");
  EXPECT_EQ(after([](Part& part) {
              part.impacts[0].free_vibration_stress.reset();
            }),
            of + "free_vibration_stress");
  EXPECT_EQ(after([](Part& part) {
              *part.impacts[0].free_vibration_deflection *= 1.02;
            }),
            of + "free_vibration_deflection");
  const std::string model = "impact DCE/blow, model 2 ";
  using Row = assessment::ImpactRow;
  EXPECT_EQ(after([](Part& part) {
              part.impacts[0].rows[1].face *= 1.003;
            }),
            model + "face_deflection");
  const std::vector<std::pair<std::optional<double> Row::*, std::string>> row =
      {{&Row::stress, "peak_von_mises"},
       {&Row::nominal, "section_stress"},
       {&Row::deflection, "deflection"}};
  for (const auto& [member, quantity] : row) {
    EXPECT_EQ(after([&, member = member](Part& part) {
                *(part.impacts[0].rows[1].*member) *= 1.003;
              }),
              model + quantity);
  }
  EXPECT_EQ(after([](Part& part) {
              part.impacts[0].rows.pop_back();
            }),
            "impact DCE/blow, model 2");
  EXPECT_EQ(after([](Part& part) {
              part.impacts.clear();
            }),
            "impact DCE/blow, impact DCE/blow, model 1, impact DCE/blow, model "
            "2");
  EXPECT_EQ(after([](Part& part) {
              *part.vibration.ratio *= 1.003;
            }),
            "vibration DCE vibration_ratio");
  EXPECT_EQ(after([](Part& part) {
              part.vibration.peak *= 1.003;
            }),
            "vibration DCE peak_von_mises");
  EXPECT_EQ(after([](Part& part) {
              part.vibration.failure = "no memory";
            }),
            "vibration DCE band_high, vibration DCE band_low, vibration DCE "
            "peak_von_mises, vibration DCE vibration_ratio, vibration DCE "
            "complete");
}

}  // namespace
}  // namespace clevis::report
