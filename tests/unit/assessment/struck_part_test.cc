// How a struck part is judged, against Timoshenko's beam under the same blow.
// Source: docs/theory.md, "Impact by finite elements".

#include <cmath>

#include <gtest/gtest.h>

#include "assessment/part_check.h"
#include "dynamics/strike.h"
#include "support/dense_system.h"
#include "support/plate_job.h"
#include "support/structured_mesh.h"

namespace clevis::assessment {
namespace {

using Eigen::Vector3d;

constexpr double kLength = 0.16, kSide = 0.008;
constexpr int kCells = 16, kStruck = 5;  // the cell whose top is struck

/// A square bar along x, clamped at x0; the top of one cell is "patch".
PartJob bar() {
  PartJob job;
  job.part.name = "bar";
  job.part.material = {"steel", 210e9, 0.0, 7850.0, 355e6};
  job.part.limits.exclude_singular_zones = true;
  job.mesh = support::structured_mesh<3>(
      {kCells, 1, 1}, 1, [](const Vector3d& x) -> Vector3d {
        return Vector3d(kLength, kSide, kSide)
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
};

BeamAnswer timoshenko(const loads::Strike& strike) {
  constexpr int kPerCell = 4;
  const support::EulerBeam beam{kLength,
                                210e9 * std::pow(kSide, 4) / 12.0,
                                7850.0 * kSide * kSide,
                                kPerCell * kCells,
                                5.0 / 6.0 * 105e9 * kSide * kSide,
                                7850.0 * std::pow(kSide, 4) / 12.0};
  Eigen::VectorXd contact = Eigen::VectorXd::Zero(2 * kPerCell * kCells);
  for (int k = 0; k <= kPerCell; ++k) {
    const double share = k == 0 || k == kPerCell ? 0.5 : 1.0;
    contact[2 * (kPerCell * kStruck + k) - 2] = share / kPerCell;
  }
  dynamics::StrikeOptions options;
  options.samples = 4000;
  const auto found = dynamics::solve_strike(
      support::dense_system(support::without_first(beam.stiffness(), 2),
                            support::without_first(beam.mass(), 2)),
      contact, strike, options, "beam");
  const Eigen::RowVectorXd tip =
      found.columns.row(found.columns.rows() - 2) * found.run.states;
  return {tip.cwiseAbs().maxCoeff(), found.run.peak_contact};
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
  EXPECT_LT(result.deflection_error, 0.02 * beam.tip);
  EXPECT_GT(result.deflection_error, 0.0);
  const ImpactResult& impact = result.impacts[0];
  EXPECT_EQ(result.deflection, impact.deflection);
  EXPECT_EQ(result.deflection, impact.rows.back().deflection);
  EXPECT_NEAR(impact.rows.back().face, beam.struck, 0.05 * beam.struck);
  EXPECT_EQ(result.verdict, PartVerdict::kFail);
  EXPECT_TRUE(result.why.starts_with("deflection")) << result.why;
}

}  // namespace
}  // namespace clevis::assessment
