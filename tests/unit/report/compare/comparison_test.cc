#include "report/compare/comparison.h"

#include <algorithm>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "part/verdict.h"
#include "report/check/result_json.h"
#include "report/compare/comparison_output.h"
#include "report/compare/result_reader.h"
#include "unit/report/sample_report.h"

namespace clevis::report {
namespace {

/// Through the file, as the user's results go.
StoredResult stored(const CheckReport& report) {
  const TestFolder folder;
  std::ofstream(folder / "result.json") << result_json(report);
  return read_result(folder.path());
}

Comparison compare_with_sample(const CheckReport& changed) {
  return compare(stored(changed), stored(sample_report()), {});
}

/// "part DCE peak_von_mises, part DCE band_low": what makes it a regression.
std::string regressions(const Comparison& comparison) {
  std::string list;
  for (const ComparisonRow& row : comparison.rows) {
    if (!is_regression(row)) continue;
    list += (list.empty() ? "" : ", ") + row.subject;
    if (!row.quantity.empty()) list += " " + row.quantity;
  }
  return list;
}

template <typename Change>
std::string regressions_after(Change change) {
  CheckReport report = sample_report();
  change(report, report.parts[0]);
  return regressions(compare_with_sample(report));
}

using Report = CheckReport;
using Part = assessment::PartResult;

TEST(Comparison, SameResultDoesNotMoveAndAllIsCompared) {
  const Comparison comparison = compare_with_sample(sample_report());
  EXPECT_EQ(regressions(comparison), "");
  EXPECT_FALSE(is_regression(comparison));
  // 2 check, 3 mechanism, 2 × 3 joints, 2 × 2 drives, 2 × (19 + 2 probes).
  EXPECT_EQ(comparison.rows.size(), 2u + 3u + 6u + 4u + 42u);
}

TEST(Comparison, HalfAPercentOfStressIsCaughtATenthIsNot) {
  EXPECT_EQ(regressions_after([](Report&, Part& part) {
              part.peak.value *= 1.005;
            }),
            "part DCE peak_von_mises");
  EXPECT_EQ(regressions_after([](Report&, Part& part) {
              part.peak.value *= 0.995;
            }),
            "part DCE peak_von_mises");
  EXPECT_EQ(regressions_after([](Report&, Part& part) {
              part.peak.value *= 1.001;
            }),
            "");
}

// A plate of 140 mm that becomes 0.1 mm longer is 7e-4 heavier; a fillet or
// a bore moves less, still more than 1e-5.
TEST(Comparison, TenthOfAMillimetreIsCaughtByTheMass) {
  EXPECT_EQ(regressions_after([](Report&, Part& part) {
              part.mass *= 1.0 + 1e-5;
            }),
            "part DCE mass");
  EXPECT_EQ(regressions_after([](Report&, Part& part) {
              part.mass *= 1.0 + 1e-9;
            }),
            "");
}

TEST(Comparison, EveryQuantityOfAPartIsHeld) {
  const auto one = [](auto member, double factor) {
    return regressions_after([&](Report&, Part& part) {
      member(part) *= factor;
    });
  };
  EXPECT_EQ(one(
                [](Part& p) -> double& {
                  return p.peak.band_low;
                },
                1.003),
            "part DCE band_low");
  EXPECT_EQ(one(
                [](Part& p) -> double& {
                  return p.peak.band_high;
                },
                1.003),
            "part DCE band_high");
  EXPECT_EQ(one(
                [](Part& p) -> double& {
                  return p.safety_factor;
                },
                0.997),
            "part DCE safety_factor");
  EXPECT_EQ(one(
                [](Part& p) -> double& {
                  return p.deflection;
                },
                1.003),
            "part DCE deflection");
  EXPECT_EQ(one(
                [](Part& p) -> double& {
                  return p.deflection_low;
                },
                1.003),
            "part DCE deflection_low");
  EXPECT_EQ(one(
                [](Part& p) -> double& {
                  return p.deflection_high;
                },
                1.003),
            "part DCE deflection_high");
  EXPECT_EQ(one(
                [](Part& p) -> double& {
                  return p.strain_energy;
                },
                1.003),
            "part DCE strain_energy");
  EXPECT_EQ(one(
                [](Part& p) -> double& {
                  return *p.mean_strain_energy;
                },
                1.003),
            "part DCE mean_strain_energy");
  EXPECT_EQ(one(
                [](Part& p) -> double& {
                  return *p.beam.peak_stress;
                },
                1.001),
            "part DCE beam_stress");
  EXPECT_EQ(one(
                [](Part& p) -> double& {
                  return p.beam.deflection;
                },
                1.001),
            "part DCE beam_deflection");
  EXPECT_EQ(one(
                [](Part& p) -> double& {
                  return *p.beam.buckling_safety;
                },
                1.001),
            "part DCE buckling_safety");
  EXPECT_EQ(one(
                [](Part& p) -> double& {
                  return p.probes[0].value;
                },
                1.003),
            "probe DCE/D stress_yy probe_stress");
  EXPECT_EQ(one(
                [](Part& p) -> double& {
                  return p.probes[1].value;
                },
                1.003),
            "probe DCE/T displacement_x probe_displacement");
}

// Where a singular zone governs it is what the part is judged by.
TEST(Comparison, PeakAwayFromSingularZonesIsHeld) {
  CheckReport sample = sample_report();
  sample.parts[0].peak_outside = sample.parts[0].peak;
  const StoredResult baseline = stored(sample);
  EXPECT_EQ(regressions(compare(stored(sample), baseline, {})), "");
  CheckReport moved = sample;
  moved.parts[0].peak_outside->value *= 1.003;
  EXPECT_EQ(regressions(compare(stored(moved), baseline, {})),
            "part DCE outside_von_mises");
  EXPECT_EQ(regressions(compare(stored(sample_report()), baseline, {})),
            "part DCE outside_high, part DCE outside_low, part DCE "
            "outside_von_mises");
}

// Added to the schema after its first files.
TEST(Comparison, BaselineMayLackWhatWasAddedLater) {
  const TestFolder folder;
  auto json = nlohmann::json::parse(result_json(sample_report()));
  json["parts"][0].erase("deflection_band_mm");
  std::ofstream(folder / "result.json") << json;
  const Comparison comparison = compare(
      stored(sample_report()), read_result(folder.path()), Tolerances());
  EXPECT_EQ(regressions(comparison), "");
  EXPECT_EQ(std::ranges::count(comparison.rows, Outcome::kNoted,
                               &ComparisonRow::outcome),
            2);
  // but not the other way round
  EXPECT_EQ(regressions(compare(read_result(folder.path()),
                                stored(sample_report()), {})),
            "part DCE deflection_high, part DCE deflection_low");
}

TEST(Comparison, ReactionsAreHeldToSixDigits) {
  EXPECT_EQ(regressions_after([](Report& report, Part&) {
              report.mechanism->joints[0].force.value *= 1.0 + 3e-6;
            }),
            "joint D peak_force");
  EXPECT_EQ(regressions_after([](Report& report, Part&) {
              report.mechanism->joints[1].moment.value = 1e-5;
            }),
            "joint E peak_moment");
  EXPECT_EQ(regressions_after([](Report& report, Part&) {
              report.mechanism->joints[1].moment.value = 1e-9;
            }),
            "");
  EXPECT_EQ(regressions_after([](Report& report, Part&) {
              report.mechanism->drives[1].effort.value *= 1.00001;
            }),
            "drive screw peak_torque");
  EXPECT_EQ(regressions_after([](Report& report, Part&) {
              report.mechanism->redundant_constraints = 1;
            }),
            "mechanism redundant_constraints");
}

TEST(Comparison, VerdictsAreExact) {
  EXPECT_EQ(regressions_after([](Report&, Part& part) {
              part.verdict = part::Verdict::kFail;
            }),
            "check verdict, part DCE verdict");
  EXPECT_EQ(regressions_after([](Report&, Part& part) {
              part.peak.verdict = assessment::PeakVerdict::kNotConverged;
            }),
            "part DCE peak_verdict");
}

TEST(Comparison, CostNeverMoves) {
  EXPECT_EQ(regressions_after([](Report& report, Part& part) {
              part.dofs *= 2;
              part.cells = 1;
              part.load_columns = 99;
              part.seconds.total *= 10.0;
              part.self_checks.residual = 1e-9;
              report.seconds[0].second = 99.0;
              report.mechanism->max_closure_error = 1e-11;
            }),
            "");
}

TEST(Comparison, PlaceInstantAndModelAreNotedUnlessAsked) {
  CheckReport changed = sample_report();
  changed.parts[0].peak.at.z() *= -1.0;
  changed.parts[0].peak.instant = 2.0;
  changed.parts[0].model = "3-D, p = 3";
  const StoredResult result = stored(changed);
  const StoredResult baseline = stored(sample_report());
  const Comparison noted = compare(result, baseline, {});
  EXPECT_FALSE(is_regression(noted));
  const std::string table = comparison_table(noted, Colour::kNone);
  EXPECT_NE(table.find("peak_position"), std::string::npos);
  EXPECT_NE(table.find("peak_instant"), std::string::npos);
  EXPECT_NE(table.find("3-D, p = 3"), std::string::npos);
  Tolerances strict;
  strict.set("peak_position", "7.9 mm", "U001", "");  // moved from +4 to -4 mm
  EXPECT_EQ(regressions(compare(result, baseline, strict)),
            "part DCE peak_position");
  strict.set("peak_position", "8.1 mm", "U001", "");
  EXPECT_EQ(regressions(compare(result, baseline, strict)), "");
}

TEST(Comparison, MissingAndNewSubjectsAreRegressions) {
  EXPECT_EQ(regressions_after([](Report& report, Part&) {
              report.parts.pop_back();
            }),
            "part BC, probe BC/D stress_yy, probe BC/T displacement_x");
  EXPECT_EQ(regressions_after([](Report& report, Part&) {
              report.mechanism->joints.push_back({"new", {}, {}});
            }),
            "joint new");
  EXPECT_EQ(regressions_after([](Report&, Part& part) {
              part.beam.buckling_safety.reset();  // written as null
            }),
            "part DCE buckling_safety");
  EXPECT_EQ(regressions_after([](Report& report, Part&) {
              report.mechanism->drives[1].kind = EffortKind::kForce;
            }),
            "drive screw peak_torque, drive screw peak_effort");
}

TEST(Comparison, SwitchedOffQuantityIsNotLookedAt) {
  CheckReport changed = sample_report();
  changed.parts[0].peak.value *= 2.0;
  Tolerances tolerances;
  tolerances.set("peak_von_mises", "off", "U001", "");
  EXPECT_FALSE(is_regression(
      compare(stored(changed), stored(sample_report()), tolerances)));
}

std::string refusal(const StoredResult& result, const StoredResult& baseline) {
  try {
    compare(result, baseline, {});
  } catch (const Error& error) {
    return error.code();
  }
  return {};
}

TEST(Comparison, StrangersAreRefused) {
  CheckReport other = sample_report();
  other.scene = "antenna";
  EXPECT_EQ(refusal(stored(other), stored(sample_report())), "R002");
  CheckReport empty = sample_report();
  empty.parts.clear();
  EXPECT_EQ(refusal(stored(sample_report()), stored(empty)), "R002");
}

TEST(ComparisonOutput, TellsQuantityValuesChangeAndTolerance) {
  CheckReport changed = sample_report();
  changed.parts[0].peak.value *= 1.005;
  const Comparison comparison = compare_with_sample(changed);
  const std::string table = comparison_table(comparison, Colour::kNone);
  EXPECT_NE(
      table.find("part DCE  peak_von_mises [MPa]       125  125.625  +0.5 %  "
                 "0.2 % + 1e-06 MPa  moved\n"),
      std::string::npos)
      << table;
  EXPECT_NE(table.find("1 of 57 quantities moved: regression (R001)"),
            std::string::npos);
  const std::string xml = comparison_junit(comparison);
  EXPECT_NE(xml.find("tests=\"57\" failures=\"1\" errors=\"0\""),
            std::string::npos);
}

TEST(ComparisonOutput, SaysHowCloseAPassWas) {
  CheckReport changed = sample_report();
  changed.parts[1].safety_factor *= 1.001;  // half of its 0.2 %
  const std::string table =
      comparison_table(compare_with_sample(changed), Colour::kNone);
  EXPECT_NE(table.find("57 quantities within their tolerances, the largest "
                       "change takes 50 % of its own"),
            std::string::npos)
      << table;
}

TEST(ComparisonOutput, JsonHoldsWhatMoved) {
  CheckReport changed = sample_report();
  changed.parts[1].peak.at.x() += 1e-3;
  changed.parts.push_back(sample_part("AB"));
  const auto json =
      nlohmann::json::parse(comparison_json(compare_with_sample(changed)));
  EXPECT_EQ(json["verdict"], "regression");
  EXPECT_EQ(json["moved"][0]["of"], "part BC");
  EXPECT_EQ(json["moved"][0]["quantity"], "peak_position");
  EXPECT_EQ(json["moved"][0]["regression"], false);
  EXPECT_DOUBLE_EQ(json["moved"][0]["result"][0], 13.5);
  EXPECT_EQ(json["moved"][1]["of"], "part AB");
  EXPECT_EQ(json["moved"][1]["outcome"], "new");
}

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
  blow.swing_stress = 1.2;
  blow.swing_deflection = 1.2;
  blow.safety_factor = 2.0;
  blow.root = assessment::HeldStress{
      .value = 200e6, .band_low = 198e6, .band_high = 203e6, .section = "root"};
  blow.refinement.stress = {170e6, 175e6, 180e6};
  blow.refinement.fronts = {4e-6, 2e-6, 1e-6};
  blow.refinement.deflection = {2e-4, 2e-4, 2e-4};
  blow.rows = {{.model = "beam, corrected", .nominal = 190e6, .face = 0.2e-3},
               {.model = "dynamic elements, 29 shapes, p = 4",
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
              part.impacts[0].swing_stress.reset();
            }),
            of + "free_swing_stress");
  EXPECT_EQ(after([](Part& part) {
              *part.impacts[0].swing_deflection *= 1.02;
            }),
            of + "free_swing_deflection");
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
