#include "report/compare/comparison.h"

#include <algorithm>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/messages/errors.h"
#include "part/verdict.h"
#include "report/compare/comparison_output.h"
#include "unit/report/compare/sample_comparison.h"

namespace clevis::report {
namespace {

using Report = CheckReport;
using Part = assessment::PartResult;

TEST(Comparison, SameResultDoesNotMoveAndAllIsCompared) {
  const Comparison comparison = compare_with_sample(sample_report());
  EXPECT_EQ(regressions(comparison), "");
  EXPECT_FALSE(is_regression(comparison));
  // 2 check, 3 mechanism, 2 × 3 joints, 2 × 2 drives, 2 × (19 + 2 probes),
  // the limits that are given.
  EXPECT_EQ(comparison.rows.size(), 2u + 3u + 6u + 4u + 42u + 4u);
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

TEST(Comparison, LoosenedLimitIsARegression) {
  EXPECT_EQ(regressions_after([](Report& report, Part&) {
              report.limits["DCE"].safety_factor = 0.5;
            }),
            "limits of DCE limit_safety_factor");
  EXPECT_EQ(regressions_after([](Report& report, Part&) {
              report.limits["DCE"].deflection.reset();
            }),
            "limits of DCE limit_deflection");
  EXPECT_EQ(regressions_after([](Report& report, Part&) {
              report.limits["BC"].exclude_singular_zones = true;
            }),
            "limits of BC limit_singular_zones");
}

TEST(Comparison, MissingAndNewSubjectsAreRegressions) {
  EXPECT_EQ(
      regressions_after([](Report& report, Part&) {
        report.parts.pop_back();
      }),
      "part BC, limits of BC, probe BC/D stress_yy, probe BC/T displacement_x");
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

}  // namespace
}  // namespace clevis::report
