#include "report/parts/part_result_json.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "part/verdict.h"
#include "unit/report/sample_report.h"

namespace clevis::report {
namespace {

using assessment::PartResult;

// Awkward bits in every kind of place: no decimal text of 17 digits or fewer
// that is converted carelessly survives this.
PartResult awkward_part() {
  PartResult part = sample_part("DCE");
  part.verdict = part::Verdict::kNotJudged;
  part.peak.verdict = assessment::PeakVerdict::kSingular;
  part.peak.value = std::nextafter(1.25e8, 2e8);
  part.peak.at = {1.0 / 3.0, -0.0, std::sqrt(2.0)};
  part.deflection = std::numeric_limits<double>::denorm_min();
  part.deflection_high = std::nextafter(2.0, 3.0);
  part.notes = {"one", "two"};
  part.peak.shares.sharing = 1.0 / 3.0;
  part.peak.has_band = true;
  part.buckling.factor = 2.0 / 3.0;
  part.finite_motion.rotation = 0.1;
  part.strain_energy = std::numeric_limits<double>::max();
  part.self_checks.reported_peak_is_field_maximum = false;
  part.peak_outside = part.peak;
  part.singular_zones = {
      {"notch", 0.5 + 1e-16, 1.0 / 3.0, {1.0, 2.0, 1.0 / 7.0}, 1e-4, true}};
  part.why = "quote \" backslash \\ newline \n µ";
  return part;
}

TEST(PartResultJson, RoundTripKeepsEveryBit) {
  const PartResult part = awkward_part();
  const PartResult back = decode_part_result(encode(part));
  // A second trip compares all members at once; the ones below make sure
  // that encode() does not leave something out both times.
  EXPECT_EQ(encode(back), encode(part));
  EXPECT_EQ(back.name, part.name);
  EXPECT_EQ(back.verdict, part.verdict);
  EXPECT_EQ(back.why, part.why);
  EXPECT_EQ(back.model, part.model);
  EXPECT_EQ(back.dofs, part.dofs);
  EXPECT_EQ(back.cells, part.cells);
  EXPECT_EQ(back.load_columns, part.load_columns);
  EXPECT_EQ(back.safety_factor, part.safety_factor);
  EXPECT_EQ(back.deflection, part.deflection);
  EXPECT_EQ(back.deflection_high, part.deflection_high);
  EXPECT_EQ(back.notes, part.notes);
  EXPECT_EQ(back.peak.shares.sharing, part.peak.shares.sharing);
  EXPECT_TRUE(back.peak.has_band);
  EXPECT_EQ(back.buckling.factor, part.buckling.factor);
  EXPECT_EQ(back.finite_motion.rotation, part.finite_motion.rotation);
  EXPECT_EQ(back.deflection_at, part.deflection_at);
  EXPECT_EQ(back.deflection_instant, part.deflection_instant);
  EXPECT_EQ(back.strain_energy, part.strain_energy);
  EXPECT_EQ(back.strain_energy_instant, part.strain_energy_instant);
  EXPECT_EQ(back.mean_strain_energy, part.mean_strain_energy);
  EXPECT_EQ(back.mass, part.mass);
  ASSERT_EQ(back.singular_zones.size(), 1u);
  EXPECT_EQ(back.singular_zones[0].name, "notch");
  EXPECT_EQ(back.singular_zones[0].exponent_measured, 1.0 / 3.0);
  EXPECT_EQ(back.singular_zones[0].at, part.singular_zones[0].at);
  EXPECT_TRUE(back.singular_zones[0].governs);
  ASSERT_TRUE(back.peak_outside);
  EXPECT_EQ(back.peak_outside->value, part.peak_outside->value);
  EXPECT_FALSE(back.held);
  EXPECT_FALSE(back.first_period);
}

TEST(PartResultJson, RoundTripKeepsThePeak) {
  const assessment::PeakStress peak = awkward_part().peak;
  const auto back = decode_part_result(encode(awkward_part())).peak;
  EXPECT_EQ(back.value, peak.value);
  EXPECT_EQ(back.band_low, peak.band_low);
  EXPECT_EQ(back.band_high, peak.band_high);
  EXPECT_EQ(back.verdict, peak.verdict);
  EXPECT_EQ(back.at, peak.at);
  EXPECT_TRUE(std::signbit(back.at.y()));
  EXPECT_EQ(back.group, peak.group);
  EXPECT_EQ(back.instant, peak.instant);
  EXPECT_EQ(back.label, peak.label);
  ASSERT_EQ(back.sequence.size(), 2u);
  EXPECT_EQ(back.sequence[1].degree, 3);
  EXPECT_EQ(back.sequence[1].dofs, 2746);
  EXPECT_EQ(back.sequence[1].peak, 124e6);
  EXPECT_EQ(back.sequence[1].strain_energy, 6.6e-3);
}

TEST(PartResultJson, RoundTripKeepsBeamChecksProbesAndSeconds) {
  const PartResult part = awkward_part();
  const PartResult back = decode_part_result(encode(part));
  EXPECT_EQ(back.beam.peak_stress, part.beam.peak_stress);
  EXPECT_EQ(back.beam.governing, part.beam.governing);
  EXPECT_EQ(back.beam.deflection, part.beam.deflection);
  EXPECT_EQ(back.beam.buckling_safety, part.beam.buckling_safety);
  EXPECT_EQ(back.beam.ratio_fe_to_beam, part.beam.ratio_fe_to_beam);
  EXPECT_EQ(back.beam.reason, part.beam.reason);
  EXPECT_EQ(back.self_checks.equilibrium, part.self_checks.equilibrium);
  EXPECT_EQ(back.self_checks.residual, part.self_checks.residual);
  EXPECT_EQ(back.self_checks.energy, part.self_checks.energy);
  EXPECT_EQ(back.self_checks.compression, part.self_checks.compression);
  EXPECT_FALSE(back.self_checks.reported_peak_is_field_maximum);
  ASSERT_EQ(back.probes.size(), 2u);
  EXPECT_EQ(back.probes[1].name, "T");
  EXPECT_EQ(back.probes[1].quantity, "displacement_x");
  EXPECT_EQ(back.probes[1].value, 1.5e-5);
  EXPECT_EQ(back.probes[1].band_low, 1.4e-5);
  EXPECT_EQ(back.probes[1].band_high, 1.6e-5);
  EXPECT_EQ(back.seconds.mesh, part.seconds.mesh);
  EXPECT_EQ(back.seconds.choose, part.seconds.choose);
  EXPECT_EQ(back.seconds.assemble, part.seconds.assemble);
  EXPECT_EQ(back.seconds.factor, part.seconds.factor);
  EXPECT_EQ(back.seconds.solve, part.seconds.solve);
  EXPECT_EQ(back.seconds.recover, part.seconds.recover);
  EXPECT_EQ(back.seconds.write, part.seconds.write);
  EXPECT_EQ(back.seconds.total, part.seconds.total);
}

TEST(PartResultJson, NonFiniteNumbersAreRefusedWherever) {
  const double inf = std::numeric_limits<double>::infinity();
  PartResult part = sample_part("DCE");
  part.safety_factor = inf;
  EXPECT_THROW(encode(part), Error);
  part = sample_part("DCE");
  part.peak.sequence[1].peak = -inf;
  EXPECT_THROW(encode(part), Error);
  part = sample_part("DCE");
  part.peak.at.y() = std::nan("");
  EXPECT_THROW(encode(part), Error);
}

TEST(PartResultJson, TornOrForeignTextIsAnInternalError) {
  const std::string text = encode(sample_part("DCE"));
  for (const std::string& torn :
       {std::string(), text.substr(0, text.size() / 2), std::string("{}"),
        std::string("[1, 2]")}) {
    try {
      decode_part_result(torn);
      FAIL() << torn;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), "X001");
    }
  }
}

}  // namespace
}  // namespace clevis::report
