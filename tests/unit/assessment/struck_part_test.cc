// How a struck part is judged, against Timoshenko's beam under the same blow.
// Source: docs/theory.md, "Impact by finite elements".

#include <cmath>

#include <gtest/gtest.h>

#include "assessment/impact/impact_check.h"
#include "assessment/part_check.h"
#include "base/messages/errors.h"
#include "dynamics/strike/strike.h"
#include "part/verdict.h"
#include "support/damped_blow.h"
#include "support/dense_system.h"
#include "support/plate_job.h"
#include "support/structured_mesh.h"

namespace clevis::assessment {
namespace {

using Eigen::Vector3d;

constexpr double kLength = 0.16, kSide = 0.008;
constexpr int kCells = 16, kStruck = 5;  // the cell whose top is struck

constexpr double kSlim = 0.06;  // height of the tip over that of the root

/// From the middle on a slim bar gets flatter.
double height(double x, bool slim) {
  return slim && x > 0.5 ? 1.0 - (2.0 * x - 1.0) * (1.0 - kSlim) : 1.0;
}

/// A square bar along x, clamped at x0; the top of one cell is "patch".
PartJob bar(bool slim = false) {
  PartJob job;
  job.part.name = "bar";
  job.part.material = {"steel", 210e9, 0.0, 7850.0, 355e6};
  job.part.limits.exclude_singular_zones = true;
  job.mesh = support::structured_mesh<3>(
      {kCells, 1, 1}, 1, [&](const Vector3d& x) -> Vector3d {
        return Vector3d(kLength, kSide * height(x.x(), slim), kSide)
            .cwiseProduct(x - Vector3d(0.0, 0.5, 0.5));
      });
  const auto patch = static_cast<int>(job.mesh.groups.size());
  job.mesh.groups.push_back({"patch", {}});
  for (auto& face : job.mesh.boundary) {
    if (face.cell == kStruck && face.face == 3) face.group = patch;
  }
  job.mass = mesh::mass_properties(job.mesh, job.part.material.density);
  for (const auto& group : job.mesh.groups) {
    const auto flat = support::flat_face(job.mesh, group.name);
    loads::GroupGeometry geometry;
    geometry.name = group.name;
    geometry.area = flat.area;
    geometry.centroid = flat.centroid;
    job.groups.push_back(geometry);
  }
  return job;
}

ImpactJob blow(const std::string& face, double mass, double speed) {
  ImpactJob impact;
  impact.strike.name = "blow";
  impact.strike.group = face;
  impact.strike.direction = -Vector3d::UnitY();
  impact.strike.mass = mass;
  impact.strike.speed = speed;
  impact.strike.contact.stiffness = 1e7;
  impact.fixed = {{"x0", {true, true, true}}};
  impact.source = "given";
  return impact;
}

/// What Timoshenko's beam says of a blow spread over the struck cell.
struct BeamAnswer {
  double tip{};     ///< largest deflection there [m]
  double struck{};  ///< largest mean deflection of the struck length [m]
  double stress{};  ///< largest of bending [Pa]
  double at{};      ///< where [m]
  double root{};    ///< largest at the clamp, by its moment [Pa]
};

constexpr int kPerCell = 4;

support::EulerBeam timoshenko_beam(bool slim) {
  return {kLength,
          210e9 * std::pow(kSide, 4) / 12.0,
          7850.0 * kSide * kSide,
          kPerCell * kCells,
          5.0 / 6.0 * 105e9 * kSide * kSide,
          7850.0 * std::pow(kSide, 4) / 12.0,
          [slim](int e) {
            return height((e + 0.5) / (kPerCell * kCells), slim);
          }};
}

Eigen::VectorXd struck_length() {
  Eigen::VectorXd contact = Eigen::VectorXd::Zero(2 * kPerCell * kCells);
  for (int k = 0; k <= kPerCell; ++k) {
    const double share = k == 0 || k == kPerCell ? 0.5 : 1.0;
    contact[2 * (kPerCell * kStruck + k) - 2] = share / kPerCell;
  }
  return contact;
}

/// @param longer  than the default duration; 0: the strike's own [1].
/// @param at_tip  struck there.
BeamAnswer timoshenko(loads::Strike strike, double longer = 2.0,
                      bool slim = false, bool at_tip = false) {
  const auto beam = timoshenko_beam(slim);
  const Eigen::Index last = 2 * kPerCell * kCells;
  const Eigen::VectorXd contact =
      at_tip ? Eigen::VectorXd(Eigen::VectorXd::Unit(last, last - 2))
             : struck_length();
  dynamics::StrikeOptions options;
  const auto system =
      support::dense_system(support::without_first(beam.stiffness(), 2),
                            support::without_first(beam.mass(), 2));
  if (longer > 0.0) {
    const auto usual =
        dynamics::solve_strike(system, contact, strike, options, "beam");
    strike.duration = longer * usual.run.time[usual.run.time.size() - 1];
  }
  options.samples = 6000;
  const auto found =
      dynamics::solve_strike(system, contact, strike, options, "beam");
  const Eigen::RowVectorXd tip =
      found.columns.row(found.columns.rows() - 2) * found.run.states;
  BeamAnswer answer{tip.cwiseAbs().maxCoeff(), found.run.peak_contact};
  const Eigen::RowVectorXd moment =
      beam.stiffness().row(1).tail(found.columns.rows()) * found.columns *
      found.run.states;
  answer.root = moment.cwiseAbs().maxCoeff() * 6.0 / std::pow(kSide, 3);
  const double size = kLength / (kPerCell * kCells);
  for (int e = 0; e < kPerCell * kCells; ++e) {
    Eigen::RowVectorXd turned = found.columns.row(2 * e + 1);
    if (e > 0) turned -= found.columns.row(2 * e - 1);
    const double bent =
        (turned * found.run.states).cwiseAbs().maxCoeff() / size;
    const double stress = bent * 210e9 * beam.height(e) * kSide / 2.0;
    if (stress <= answer.stress) continue;
    answer.stress = stress;
    answer.at = (e + 0.5) * size;
  }
  return answer;
}

// A light striker on a third of the length: the tip swings out much farther
// than the struck face, and not as at rest.
TEST(StruckPart, DeflectsAsTimoshenkosBeamBeyondTheBlow) {
  PartJob job = bar();
  job.impacts = {blow("patch", 0.02, 2.0)};
  const BeamAnswer beam = timoshenko(job.impacts[0].strike);
  job.part.limits.deflection = 0.9 * beam.tip;
  const PartResult result = check_part(job).result;
  EXPECT_GT(beam.tip, 2.0 * beam.struck);
  EXPECT_NEAR(result.deflection, beam.tip, 0.02 * beam.tip);
  EXPECT_NEAR(result.deflection_at.x(), kLength, 1e-9);
  EXPECT_LT(result.deflection_high, 1.02 * result.deflection);
  EXPECT_GT(result.deflection_high, result.deflection);
  EXPECT_LT(result.deflection_low, result.deflection);
  const ImpactResult& impact = result.impacts[0];
  EXPECT_EQ(result.deflection, impact.deflection);
  EXPECT_EQ(result.deflection, impact.rows.back().deflection);
  EXPECT_NEAR(impact.rows.back().face, beam.struck, 0.05 * beam.struck);
  EXPECT_EQ(result.verdict, part::Verdict::kFail);
  EXPECT_TRUE(result.why.starts_with("deflection")) << result.why;
}

// At rest nothing stresses the bar beyond the blow. In time its slim end whips,
// and is bent most there.
TEST(StruckPart, IsJudgedWhereItIsStressedInTime) {
  PartJob job = bar(true);
  job.impacts = {blow("patch", 0.002, 1.0)};
  job.impacts[0].strike.contact.stiffness = 1e6;
  const BeamAnswer beam = timoshenko(job.impacts[0].strike, 2.0, true);
  const PartAssessment found = check_part(job);
  const PeakStress& judged = judged_peak(found.result);
  EXPECT_GT(beam.at, 0.8 * kLength);
  EXPECT_NEAR(judged.value, beam.stress, 0.03 * beam.stress);
  EXPECT_NEAR(judged.at.x(), beam.at, 0.04 * kLength);
  EXPECT_LT(judged.band_high - judged.band_low, 0.1 * beam.stress);
  EXPECT_EQ(judged.value, found.result.impacts[0].stress);
  EXPECT_EQ(judged.value, found.result.impacts[0].rows.back().stress);
  // what is written is the field of that instant
  const auto& fields = found.fields;
  EXPECT_NEAR(fields.times[static_cast<std::size_t>(fields.peak_instant)],
              found.result.peak.instant, 1e-15);
  const auto field = fields.at(fields.peak_instant, fields.worst.subdivisions);
  double highest = 0.0;
  for (const auto& cell : field.stress) {
    highest = std::max(highest, stress::von_mises(cell).maxCoeff());
  }
  EXPECT_NEAR(highest, found.result.peak.value, 1e-6 * highest);
}

// The stress beside the edge that is left out is too rough to tell what the
// root bears: the support's force and moment do, and the part fails by them.
TEST(StruckPart, RootHasTheMomentOfItsSupportInTime) {
  for (const auto& [face, mass] :
       {std::pair{"x1", 0.002}, {"x1", 0.2}, {"patch", 0.02}}) {
    const bool at_tip = std::string(face) == "x1";
    PartJob job = bar();
    job.part.material.poissons_ratio = 0.3;  // makes an edge without bound
    job.impacts = {blow(face, mass, 1.0)};
    job.impacts[0].strike.contact.stiffness = 3e5;
    const BeamAnswer beam =
        timoshenko(job.impacts[0].strike, 2.0, false, at_tip);
    job.part.limits.safety_factor = 355e6 / (0.95 * beam.root);
    const PartResult result = check_part(job).result;
    EXPECT_EQ(result.held->section, "x0");
    // Poisson's ratio makes the clamp stiffer than the beam's
    EXPECT_NEAR(result.held->value, beam.root, 0.025 * beam.root)
        << face << mass;
    EXPECT_LT(result.held->band_high - result.held->band_low, 0.02 * beam.root);
    EXPECT_EQ(result.held->value, result.impacts[0].rows.back().nominal);
    // beam theory has no factor of a blow without a force; rows compare still
    EXPECT_EQ(result.impacts[0].rows.back().ratio, 1.0);
    EXPECT_LT(judged_peak(result).band_low, 0.95 * beam.root);
    EXPECT_EQ(result.verdict, part::Verdict::kFail);
    EXPECT_TRUE(result.why.starts_with("nominal stress")) << result.why;
  }
}

// A blow that stresses the rest of the part less may bend the root more: both
// count.
TEST(StruckPart, RootsOfAllBlowsCount) {
  PartJob job = bar();
  job.part.material.poissons_ratio = 0.3;
  ImpactJob light = blow("x1", 0.002, 6.0);
  light.strike.name = "light";
  light.strike.contact.stiffness = 3e5;
  ImpactJob heavy = blow("x1", 0.2, 0.7);
  heavy.strike.contact.stiffness = 3e5;
  job.impacts = {light, heavy};
  const PartResult result = check_part(job).result;
  const double first = result.impacts[0].root->value;
  const double second = result.impacts[1].root->value;
  EXPECT_GT(result.impacts[1].stress, result.impacts[0].stress);
  EXPECT_GT(first, second);
  EXPECT_EQ(result.held->value, first);
  EXPECT_EQ(result.held->label, "impact light");
}

// A pressed striker that bounces hits the swinging part sooner or later, by
// small changes: one per cent more mass must not leave the band.
TEST(StruckPart, BandHoldsTheScatterOfABouncingStriker) {
  double lowest = 1e300, highest = 0.0;
  PartResult result;
  for (const double heavier : {1.0, 0.99}) {
    PartJob job = bar();
    job.impacts = {blow("x1", 0.01 * heavier, 2.0)};
    job.impacts[0].strike.force = 20.0;
    const PartResult found = check_part(job).result;
    if (heavier == 1.0) result = found;
    lowest = std::min(lowest, found.impacts[0].root->value);
    highest = std::max(highest, found.impacts[0].root->value);
  }
  const ImpactResult& impact = result.impacts[0];
  EXPECT_GT(highest, 1.02 * lowest);
  EXPECT_GT(impact.spread, 0.02);
  EXPECT_LE(impact.root->band_low, lowest);
  EXPECT_GE(impact.root->band_high, highest);
}

// What a force presses bounces on, and its largest blow comes late. The course
// is told as long as it can be, by few shapes for sixteen default durations: a
// limit that is only exceeded late does not pass.
TEST(StruckPart, IsFollowedWhileAForcePresses) {
  PartJob job = bar();
  job.impacts = {blow("patch", 0.01, 0.5)};
  job.impacts[0].strike.force = 10.0;
  const auto& strike = job.impacts[0].strike;
  const double early = timoshenko(strike, 1.0).stress;
  const double late = timoshenko(strike, 16.0).stress;
  EXPECT_GT(late, 1.25 * early);
  job.part.limits.safety_factor = 355e6 / (0.95 * late);
  const PartResult result = check_part(job).result;
  const PeakStress& judged = judged_peak(result);
  const ImpactResult& impact = result.impacts[0];
  EXPECT_GT(judged.value, 0.95 * early);
  EXPECT_GT(judged.band_high, 0.95 * late);
  EXPECT_LT(judged.band_high, 1.5 * late);
  EXPECT_GT(impact.later_stress, 1.0);
  EXPECT_EQ(result.verdict, part::Verdict::kNotJudged);
}

// Each mode loses at its own pace, 2 ζ ω: Timoshenko's beam by Runge and Kutta.
TEST(StruckPart, LosesByItsDamping) {
  PartJob job = bar();
  job.part.damping = 0.05;
  job.impacts = {blow("patch", 0.02, 2.0)};
  const auto beam = timoshenko_beam(false);
  const Eigen::Index tip = 2 * kPerCell * kCells - 2;
  Eigen::MatrixXd rows(2, tip + 2);  // way of the tip, stress at the root
  rows.row(0) = Eigen::RowVectorXd::Unit(tip + 2, tip);
  rows.row(1) =
      beam.stiffness().row(1).tail(tip + 2) * 6.0 / std::pow(kSide, 3);
  const auto answer = [&](double damping) {
    return support::damped_blow(support::without_first(beam.stiffness(), 2),
                                support::without_first(beam.mass(), 2),
                                struck_length(), rows,
                                {0.02, 2.0, 1e7, damping}, 5e-3, 16);
  };
  const auto lossless = answer(0.0), damped = answer(0.05);
  const ImpactResult found = check_blows(job).impacts.front();
  EXPECT_LT(damped.largest[0], 0.96 * lossless.largest[0]);
  EXPECT_NEAR(found.deflection, damped.largest[0], 0.005 * damped.largest[0]);
  EXPECT_NEAR(found.peak_force, damped.force, 0.01 * damped.force);
  EXPECT_NEAR(found.root->value, damped.largest[1], 0.02 * damped.largest[1]);
  EXPECT_EQ(found.later_stress, 1.0);
  EXPECT_EQ(found.later_deflection, 1.0);
}

// A light striker leaves at once and the bar swings on: its shapes meet later
// than anyone looks, never beyond the sum of their amplitudes.
TEST(StruckPart, SwingsNoFartherThanItsShapesTogether) {
  PartJob job = bar();
  job.impacts = {blow("patch", 0.02, 2.0)};
  const auto& strike = job.impacts[0].strike;
  const BeamAnswer early = timoshenko(strike), late = timoshenko(strike, 60.0);
  const ImpactResult found = check_blows(job).impacts.front();
  EXPECT_GT(late.tip, 1.005 * early.tip);
  EXPECT_GT(found.free_vibration_deflection.value(), late.tip / early.tip);
  EXPECT_LT(found.free_vibration_deflection.value(), 1.4);
  EXPECT_GT(found.free_vibration_stress.value(), late.stress / early.stress);
  EXPECT_LT(found.free_vibration_stress.value(), 1.6);
  job.part.damping = 0.01;
  EXPECT_FALSE(check_blows(job).impacts.front().free_vibration_stress);
}

// A time that ends while the striker presses leaves the worst out.
TEST(StruckPart, IsNotJudgedWhereItsTimeIsCut) {
  PartJob job = bar();
  job.impacts = {blow("patch", 0.2, 0.1)};
  job.impacts[0].strike.duration = 5e-4;
  const PartResult cut = check_part(job).result;
  EXPECT_TRUE(cut.impacts[0].is_cut);
  EXPECT_EQ(cut.verdict, part::Verdict::kNotJudged);
  EXPECT_NE(cut.why.find("still presses"), std::string::npos) << cut.why;
  EXPECT_GT(cut.impacts[0].later_stress, 1.1);
  job.impacts[0].strike.duration.reset();
  const PartResult whole = check_part(job).result;
  EXPECT_FALSE(whole.impacts[0].is_cut);
  EXPECT_EQ(whole.verdict, part::Verdict::kPass) << whole.why;
}

TEST(StruckPart, IsRefusedOnAHeldFace) {
  PartJob job = bar();
  job.impacts = {blow("x0", 0.2, 0.1)};
  try {
    check_part(job);
    FAIL() << "not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "F006");
  }
}

// 4 l/c of a rod that stretches, not its bending's.
TEST(StruckPart, PeriodIsThatAlongTheBlow) {
  PartJob job = bar();
  job.impacts = {blow("x1", 0.2, 0.1)};
  job.impacts[0].strike.direction = -Vector3d::UnitX();
  const PartResult result = check_part(job).result;
  const double stretching = 4.0 * kLength / std::sqrt(210e9 / 7850.0);
  EXPECT_NEAR(result.impacts[0].first_period, stretching, 0.01 * stretching);
  EXPECT_TRUE(result.impacts[0].is_axial);
}

// A force put on at once: twice its static stress and way.
TEST(StruckPart, ForceWithoutSpeed) {
  PartJob job = bar();
  job.impacts = {blow("x1", 5.0, 0.0)};
  job.impacts[0].strike.force = 10.0;
  const PartResult result = check_part(job).result;
  const double at_rest =
      10.0 * std::pow(kLength, 3) / (3.0 * 210e9 * std::pow(kSide, 4) / 12.0);
  EXPECT_NEAR(result.deflection, 2.0 * at_rest, 0.03 * 2.0 * at_rest);
}

}  // namespace
}  // namespace clevis::assessment
