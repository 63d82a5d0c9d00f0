#include "assessment/verdict/verdict.h"

#include <gtest/gtest.h>

#include "part/verdict.h"

namespace clevis::assessment {
namespace {

part::PartDefinition steel_part() {
  part::PartDefinition part;
  part.material = {"steel", 210e9, 0.3, 7850.0, 300e6};
  part.limits.safety_factor = 1.5;  // allows 200 MPa
  part.limits.deflection = 0.5e-3;
  return part;
}

PartResult converged(double low, double value, double high) {
  PartResult result;
  result.peak.value = value;
  result.peak.band_low = low;
  result.peak.band_high = high;
  result.peak.verdict = PeakVerdict::kConverged;
  result.deflection = 0.1e-3;
  return result;
}

PartResult judged(const part::PartDefinition& part, PartResult result) {
  judge(part, result);
  return result;
}

TEST(Verdict, PassesOnlyIfTheWholeBandIsWithin) {
  EXPECT_EQ(judged(steel_part(), converged(190e6, 195e6, 199e6)).verdict,
            part::Verdict::kPass);
  const PartResult doubtful =
      judged(steel_part(), converged(198e6, 199e6, 201e6));
  EXPECT_EQ(doubtful.verdict, part::Verdict::kNotJudged);
  EXPECT_NE(doubtful.why.find("inside the band"), std::string::npos);
  EXPECT_EQ(judged(steel_part(), converged(201e6, 202e6, 203e6)).verdict,
            part::Verdict::kFail);
}

TEST(Verdict, PeakThatDoesNotSettleIsNotJudgedHoweverSmall) {
  for (const auto verdict :
       {PeakVerdict::kSingular, PeakVerdict::kNotConverged}) {
    PartResult result = converged(1e6, 1e6, 1e6);
    result.peak.verdict = verdict;
    EXPECT_EQ(judged(steel_part(), result).verdict, part::Verdict::kNotJudged);
  }
}

TEST(Verdict, BandBeyondTheLimitFailsEvenIfNotConverged) {
  PartResult result = converged(300e6, 320e6, 340e6);
  result.peak.verdict = PeakVerdict::kNotConverged;
  EXPECT_EQ(judged(steel_part(), result).verdict, part::Verdict::kFail);
  result.peak.verdict = PeakVerdict::kSingular;
  EXPECT_EQ(judged(steel_part(), result).verdict, part::Verdict::kNotJudged);
}

/// Not converged, but of three degrees that do not grow without bound.
PartResult unsettled(double low, double value, double high) {
  PartResult result = converged(low, value, high);
  result.peak.verdict = PeakVerdict::kNotConverged;
  result.peak.has_band = true;
  result.peak.shares.mesh = high - value;
  return result;
}

TEST(Verdict, WideBandDecidesWhereItLiesClearOfTheLimit) {
  // 200 MPa are allowed.
  const PartResult passed =
      judged(steel_part(), unsettled(101e6, 120e6, 140e6));
  EXPECT_EQ(passed.verdict, part::Verdict::kPass);
  EXPECT_NE(passed.why.find("not converged (17 % mesh"), std::string::npos)
      << passed.why;
  EXPECT_EQ(judged(steel_part(), unsettled(201e6, 240e6, 280e6)).verdict,
            part::Verdict::kFail);
  // Within, but not with twice the reach: 190 + 2 · 9.
  EXPECT_EQ(judged(steel_part(), unsettled(181e6, 190e6, 199e6)).verdict,
            part::Verdict::kNotJudged);
  EXPECT_EQ(judged(steel_part(), unsettled(150e6, 190e6, 230e6)).verdict,
            part::Verdict::kNotJudged);
  PartResult unfounded = unsettled(101e6, 120e6, 140e6);
  unfounded.peak.has_band = false;  // two degrees, or a growing sequence
  EXPECT_EQ(judged(steel_part(), unfounded).verdict, part::Verdict::kNotJudged);
}

TEST(Verdict, NamesTheSourceOfDoubt) {
  const auto remedy = [](double ErrorShares::*share) {
    PartResult result = unsettled(150e6, 190e6, 230e6);
    result.peak.shares = {.mesh = 1e6};
    result.peak.shares.*share += 39e6;
    return judged(steel_part(), result).why;
  };
  EXPECT_NE(remedy(&ErrorShares::mesh).find("mesh finer"), std::string::npos);
  const std::string time = remedy(&ErrorShares::time);
  EXPECT_NE(time.find("21 % time"), std::string::npos) << time;
  EXPECT_NE(time.find("give more instants"), std::string::npos) << time;
  EXPECT_EQ(time.find("mesh finer"), std::string::npos) << time;
  EXPECT_NE(remedy(&ErrorShares::model).find("--model"), std::string::npos);
  EXPECT_NE(remedy(&ErrorShares::sharing).find("compliance"),
            std::string::npos);
}

// No tolerance narrows what the joints, instants or change points leave open.
TEST(Verdict, AdvisesATighterToleranceWhereThatHelps) {
  const auto remedy = [](double ErrorShares::*share) {
    PartResult result = converged(132e6, 190e6, 230e6);
    result.peak.shares = {.mesh = 1e6, .model = 1e6};
    result.peak.shares.*share += 39e6;
    return judged(steel_part(), result).why;
  };
  EXPECT_TRUE(remedy(&ErrorShares::mesh)
                  .ends_with("MPa: tighten --tolerance, or mesh finer there"))
      << remedy(&ErrorShares::mesh);
  EXPECT_NE(remedy(&ErrorShares::model).find("tighten --tolerance, or take"),
            std::string::npos);
  EXPECT_TRUE(
      remedy(&ErrorShares::sharing)
          .ends_with(
              "MPa: give the joints their `compliance`, as the note on them "
              "says"))
      << remedy(&ErrorShares::sharing);
  EXPECT_TRUE(remedy(&ErrorShares::time).ends_with("[simulation])"));
  PartResult bent = converged(9e6, 10e6, 40e6);
  bent.peak.shares = {.mesh = 1e6, .sharing = 30e6};
  bent.deflection_low = 0.1e-3;
  bent.deflection_high = 0.6e-3;
  const std::string why = judged(steel_part(), bent).why;
  EXPECT_TRUE(why.ends_with(
      "mm: give the joints their `compliance`, as the note on them says"))
      << why;
}

TEST(Verdict, DeflectionIsHeldAgainstItsBand) {
  // 0.5 mm are allowed.
  const auto with = [](double low, double value, double high) {
    PartResult result = converged(9e6, 10e6, 11e6);
    result.deflection = value;
    result.deflection_low = low;
    result.deflection_high = high;
    return judged(steel_part(), result);
  };
  EXPECT_EQ(with(0.48e-3, 0.485e-3, 0.49e-3).verdict, part::Verdict::kPass);
  const PartResult open = with(0.48e-3, 0.495e-3, 0.51e-3);
  EXPECT_EQ(open.verdict, part::Verdict::kNotJudged);
  EXPECT_NE(open.why.find("band of the deflection"), std::string::npos);
  EXPECT_EQ(with(0.505e-3, 0.51e-3, 0.515e-3).verdict, part::Verdict::kFail);
}

/// A singular peak of 900 MPa, and 150 MPa away from its zone.
PartResult with_zone(double low, double value, double high) {
  PartResult result = converged(800e6, 900e6, 1000e6);
  result.peak.verdict = PeakVerdict::kSingular;
  result.singular_zones = {
      {"notch at (1.0, 2.0) mm", 0.54, 0.54, {}, 1e-3, true}};
  result.peak_outside = converged(low, value, high).peak;
  result.peak_outside->sequence = {{4, 1000, value, 1.0}};
  return result;
}

TEST(Verdict, SingularPartIsJudgedAwayFromItsZoneOnlyIfAsked) {
  part::PartDefinition part = steel_part();
  const PartResult open = judged(part, with_zone(149e6, 150e6, 151e6));
  EXPECT_EQ(open.verdict, part::Verdict::kNotJudged);
  EXPECT_NE(open.why.find("notch at (1.0, 2.0) mm"), std::string::npos);
  part.limits.exclude_singular_zones = true;
  EXPECT_EQ(judged(part, with_zone(149e6, 150e6, 151e6)).verdict,
            part::Verdict::kPass);
  PartResult unsettled = with_zone(100e6, 150e6, 190e6);
  unsettled.peak_outside->verdict = PeakVerdict::kNotConverged;
  unsettled.peak_outside->has_band = true;
  EXPECT_EQ(judged(part, unsettled).verdict, part::Verdict::kNotJudged);
  // With five times the reach: 20 + 5 · 15 of 300.
  PartResult far = with_zone(10e6, 20e6, 35e6);
  far.peak_outside->verdict = PeakVerdict::kNotConverged;
  far.peak_outside->has_band = true;
  const PartResult passed = judged(part, far);
  EXPECT_EQ(passed.verdict, part::Verdict::kPass);
  EXPECT_NE(passed.why.find("not converged"), std::string::npos);
  EXPECT_NE(passed.why.find("notch at (1.0, 2.0) mm"), std::string::npos);
}

/// A blow that stresses the part as judged, with that nominal stress at the
/// root.
PartResult with_blow(double nominal) {
  PartResult result = with_zone(145e6, 150e6, 155e6);
  ImpactResult blow;
  blow.name = "hammer";
  blow.stress = 150e6;
  blow.band_low = 145e6;
  blow.band_high = 155e6;
  result.impacts.push_back(blow);
  for (ZoneResult& zone : result.singular_zones) zone.has_section = true;
  result.held = SupportStress{
      nominal, nominal * 145.0 / 150.0, nominal * 155.0 / 150.0, "root",
      0.0,     "impact hammer"};
  return result;
}

TEST(Verdict, ZoneLeftOutDoesNotHideTheNominalStress) {
  auto part = steel_part();
  part.limits.exclude_singular_zones = true;
  const PartResult failed = judged(part, with_blow(220e6));
  EXPECT_EQ(failed.verdict, part::Verdict::kFail);
  EXPECT_NE(failed.why.find("220 [212.7, 227.3] MPa"), std::string::npos)
      << failed.why;
  EXPECT_EQ(judged(part, with_blow(198e6)).verdict, part::Verdict::kNotJudged);
  const PartResult passed = judged(part, with_blow(190e6));
  EXPECT_EQ(passed.verdict, part::Verdict::kPass);
  EXPECT_NE(passed.why.find("190 MPa"), std::string::npos) << passed.why;

  PartResult notched = with_blow(190e6);
  notched.singular_zones.push_back(notched.singular_zones[0]);
  notched.singular_zones.back().name = "notch";
  notched.singular_zones.back().has_section = false;
  EXPECT_NE(judged(part, notched).why.find("; WITHOUT notch:"),
            std::string::npos)
      << judged(part, notched).why;

  PartResult at_rest = with_zone(145e6, 150e6, 155e6);
  EXPECT_NE(judged(part, at_rest).why.find("may be higher"), std::string::npos);
  at_rest.beam.governing = "axial + bending, C-B at 30 mm";
  at_rest.beam.is_section = true;
  at_rest.beam.peak_stress = 210e6;
  EXPECT_EQ(judged(part, at_rest).verdict, part::Verdict::kFail);
  at_rest.beam.governing = "lug shear-out, bore_B";
  at_rest.beam.is_section = false;
  EXPECT_EQ(judged(part, at_rest).verdict, part::Verdict::kPass);
}

TEST(Verdict, SingularPartFailsByItsStressElsewhere) {
  part::PartDefinition part = steel_part();
  EXPECT_EQ(judged(part, with_zone(201e6, 202e6, 203e6)).verdict,
            part::Verdict::kFail);
  part.limits.exclude_singular_zones = true;
  EXPECT_EQ(judged(part, with_zone(201e6, 202e6, 203e6)).verdict,
            part::Verdict::kFail);
}

TEST(Verdict, OneLimitFailsWhereAnotherCannotBeJudged) {
  part::PartDefinition part = steel_part();
  part.limits.deflection = 1e-3;
  PartResult open = with_zone(149e6, 150e6, 151e6);
  open.deflection = 0.9e-3;
  EXPECT_EQ(judged(part, open).verdict, part::Verdict::kNotJudged);
  EXPECT_NE(judged(part, open).why.find("notch"), std::string::npos);
  open.deflection = 1.1e-3;
  const PartResult failed = judged(part, open);
  EXPECT_EQ(failed.verdict, part::Verdict::kFail);
  EXPECT_TRUE(failed.why.starts_with("deflection")) << failed.why;
}

TEST(Verdict, PartWithoutAnyStressIsNotJudged) {
  const PartResult result = judged(steel_part(), converged(0.0, 0.0, 0.0));
  EXPECT_EQ(result.verdict, part::Verdict::kNotJudged);
  EXPECT_NE(result.why.find("nothing stresses"), std::string::npos);
}

TEST(Verdict, WithoutALimitTheYieldStrengthIsOne) {
  part::PartDefinition part = steel_part();
  part.limits = {};
  EXPECT_EQ(judged(part, converged(290e6, 295e6, 299e6)).verdict,
            part::Verdict::kPass);
  EXPECT_EQ(judged(part, converged(301e6, 302e6, 303e6)).verdict,
            part::Verdict::kFail);
}

TEST(Verdict, DeflectionAndBucklingCanFailAPartOfLowStress) {
  PartResult bent = converged(9e6, 10e6, 11e6);
  bent.deflection = 0.51e-3;
  EXPECT_EQ(judged(steel_part(), bent).verdict, part::Verdict::kFail);
  PartResult slender = converged(9e6, 10e6, 11e6);
  slender.buckling.euler = 1.4;
  EXPECT_EQ(judged(steel_part(), slender).verdict, part::Verdict::kFail);
  slender.buckling.euler = 1.6;
  EXPECT_EQ(judged(steel_part(), slender).verdict, part::Verdict::kPass);
}

PartResult that_buckles_at(double low, double factor, double high) {
  PartResult result = converged(100e6, 101e6, 102e6);
  result.buckling.factor = factor;
  result.buckling.band_low = low;
  result.buckling.band_high = high;
  result.buckling.label = "t = 1 s";
  return result;
}

TEST(Verdict, BucklingIsJudgedByItsBand) {
  const part::PartDefinition part = steel_part();  // safety factor 1.5
  EXPECT_EQ(judged(part, that_buckles_at(1.51, 1.6, 1.7)).verdict,
            part::Verdict::kPass);
  EXPECT_EQ(judged(part, that_buckles_at(1.4, 1.6, 1.7)).verdict,
            part::Verdict::kNotJudged);
  const PartResult fails = judged(part, that_buckles_at(1.3, 1.4, 1.49));
  EXPECT_EQ(fails.verdict, part::Verdict::kFail);
  EXPECT_NE(fails.why.find("1.4 [1.3, 1.49]"), std::string::npos) << fails.why;
  part::PartDefinition own = part;
  own.limits.buckling = 1.2;
  EXPECT_EQ(judged(own, that_buckles_at(1.3, 1.4, 1.49)).verdict,
            part::Verdict::kPass);
}

// Finite elements decide but where the strut reaches into another body.
TEST(Verdict, EulersStrutDecidesWhereItIsLongerThanThePart) {
  PartResult result = that_buckles_at(3.0, 3.1, 3.2);
  result.buckling.euler = 1.2;
  EXPECT_EQ(judged(steel_part(), result).verdict, part::Verdict::kPass);
  result.buckling.strut_is_longer = true;
  const PartResult fails = judged(steel_part(), result);
  EXPECT_EQ(fails.verdict, part::Verdict::kFail);
  EXPECT_NE(fails.why.find("Euler"), std::string::npos);
  result.buckling = {};
  result.buckling.euler = 1.2;
  EXPECT_EQ(judged(steel_part(), result).verdict, part::Verdict::kFail);
}

// What could not be computed is held against no limit, be it one by default;
// a strut by Euler is enough for that.
TEST(Verdict, BucklingThatIsNotComputedDoesNotPass) {
  PartResult result = converged(100e6, 101e6, 102e6);
  result.buckling.remark = "not computed: no memory";
  const PartResult open = judged(steel_part(), result);
  EXPECT_EQ(open.verdict, part::Verdict::kNotJudged);
  EXPECT_NE(open.why.find("no memory"), std::string::npos) << open.why;
  result.buckling.euler = 1.6;
  EXPECT_EQ(judged(steel_part(), result).verdict, part::Verdict::kPass);
  part::PartDefinition own = steel_part();
  own.limits.buckling = 1.2;
  EXPECT_EQ(judged(own, result).verdict, part::Verdict::kNotJudged);
}

// Stress and deflection are within; what they are worth is not.
TEST(Verdict, PartThatTurnsFarDoesNotPass) {
  PartResult result = converged(100e6, 101e6, 102e6);
  result.finite_motion = {0.08, 0.001, "t = 1 s"};  // 4.6°
  EXPECT_EQ(judged(steel_part(), result).verdict, part::Verdict::kPass);
  result.finite_motion.rotation = 0.09;  // 5.2°
  const PartResult turned = judged(steel_part(), result);
  EXPECT_EQ(turned.verdict, part::Verdict::kNotJudged);
  EXPECT_NE(turned.why.find("5.16°"), std::string::npos) << turned.why;
  EXPECT_NE(turned.why.find("t = 1 s"), std::string::npos);
  result.finite_motion = {0.01, 0.06, "t = 1 s"};
  EXPECT_EQ(judged(steel_part(), result).verdict, part::Verdict::kNotJudged);
}

TEST(Verdict, PartThatFailsAndTurnsFarSaysBoth) {
  PartResult result = converged(301e6, 302e6, 303e6);
  result.finite_motion = {0.5, 0.001, "t = 1 s"};
  const PartResult failed = judged(steel_part(), result);
  EXPECT_EQ(failed.verdict, part::Verdict::kFail);
  ASSERT_EQ(failed.notes.size(), 1U);
  EXPECT_NE(failed.notes[0].find("28.6°"), std::string::npos);
}

}  // namespace
}  // namespace clevis::assessment
