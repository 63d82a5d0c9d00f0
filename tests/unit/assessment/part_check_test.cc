#include "assessment/part_check.h"

#include <cmath>
#include <numbers>
#include <string>
#include <tuple>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "assessment/ladder/degree_climb.h"
#include "assessment/models/plate_models.h"
#include "base/messages/errors.h"
#include "elasticity/problem/displacement_basis.h"
#include "elasticity/solid/solid_solve.h"
#include "mesh/quality/mass_properties.h"
#include "part/verdict.h"
#include "support/annulus_mesh.h"

namespace clevis::assessment {
namespace {

using Eigen::Vector3d;

/// A bar 60 × 10 × 4 mm pulled by 10 MPa at both ends.
PartJob pulled_bar() {
  PartJob job;
  job.part.name = "bar";
  job.part.material = {"steel", 210e9, 0.3, 7850.0, 300e6};
  job.mesh = support::structured_mesh<3>(
      {6, 2, 1}, 1, [](const Vector3d& x) -> Vector3d {
        return x.cwiseProduct(Vector3d(0.06, 0.01, 0.004));
      });
  job.mass = mesh::mass_properties(job.mesh, 7850.0);
  LoadSet set;
  loads::InstantLoad instant;
  instant.label = "pull";
  for (const auto& [name, side] : {std::pair{"x0", -1.0}, {"x1", 1.0}}) {
    loads::SurfaceLoad load;
    load.group = name;
    load.traction = Vector3d(side * 10e6, 0, 0);
    load.resultant.force = 0.01 * 0.004 * load.traction;
    load.resultant.moment = Vector3d(side < 0 ? 0.0 : 0.06, 0.005, 0.002)
                                .cross(load.resultant.force);
    instant.surface_loads.push_back(load);
  }
  set.history.instants.push_back(instant);
  job.load_sets.push_back(set);
  return job;
}

TEST(PartCheck, PlateInItsPlaneIsSolvedAsPlaneStress) {
  const PartResult result = check_part(pulled_bar()).result;
  EXPECT_EQ(result.model, "plane stress, p = 4");
  EXPECT_NEAR(result.peak.value, 10e6, 1e-3);
  EXPECT_NEAR(result.safety_factor, 30.0, 1e-6);
  // Energy of a uniform stress: σ²/(2E) V.
  EXPECT_NEAR(result.strain_energy,
              10e6 * 10e6 / (2 * 210e9) * 0.06 * 0.01 * 0.004, 1e-12);
}

TEST(PartCheck, SolidAndPlaneModelAgreeWhereBothAreExact) {
  PartJob job = pulled_bar();
  job.model = ModelKind::kSolid;
  const PartResult result = check_part(job).result;
  EXPECT_EQ(result.model.substr(0, 3), "3-D");
  EXPECT_NEAR(result.peak.value, 10e6, 1.0);
}

/// The job's load as a ramp from nothing over two seconds.
PartJob ramped(PartJob job, int steps) {
  auto& instants = job.load_sets[0].history.instants;
  const loads::InstantLoad full = instants[0];
  instants.clear();
  for (int i = 0; i <= steps; ++i) {
    const double share = double(i) / steps;
    loads::InstantLoad instant = full;
    instant.time = 2.0 * share;
    instant.label = "t = " + std::to_string(instant.time) + " s";
    for (auto& load : instant.surface_loads) {
      load.traction *= share;
      load.total *= share;
      load.resultant.force *= share;
      load.resultant.moment *= share;
    }
    instants.push_back(instant);
  }
  return job;
}

// F²L/(2EA) at the end of a ramp, and as the square of the load before: a
// third in the mean, and what trapezoids add to a square.
TEST(PartCheck, StrainEnergyOfARampFollowsItsSquare) {
  constexpr int kSteps = 10;
  const PartAssessment found = check_part(ramped(pulled_bar(), kSteps));
  const double force = 10e6 * 0.01 * 0.004;
  const double exact = force * force * 0.06 / (2.0 * 210e9 * 0.01 * 0.004);
  constexpr double kSolver = 1e-6;
  EXPECT_NEAR(found.result.strain_energy, exact, kSolver * exact);
  EXPECT_EQ(found.result.strain_energy_instant, 2.0);
  ASSERT_TRUE(found.result.mean_strain_energy);
  EXPECT_NEAR(*found.result.mean_strain_energy,
              exact * (1.0 / 3.0 + 1.0 / (6.0 * kSteps * kSteps)),
              kSolver * exact);
  ASSERT_EQ(found.fields.history.size(), kSteps + 1u);
  for (const InstantRow& row : found.fields.history) {
    const double share = row.time / 2.0;
    EXPECT_NEAR(row.strain_energy, share * share * exact, kSolver * exact);
  }
  EXPECT_FALSE(check_part(pulled_bar()).result.mean_strain_energy);
}

/// The bar of 6 × 2 × 1 cells, clamped at x0 and bent at x1.
PartJob cantilever() {
  PartJob job = pulled_bar();
  LoadSet& set = job.load_sets[0];
  set.fixed = {{"x0", {true, true, true}}};
  auto& loads = set.history.instants[0].surface_loads;
  loads.erase(loads.begin());
  loads[0].traction = Vector3d(0.0, 5e6, 0.0);
  loads[0].resultant.force = 0.01 * 0.004 * loads[0].traction;
  loads[0].resultant.moment =
      Vector3d(0.06, 0.005, 0.002).cross(loads[0].resultant.force);
  return job;
}

// F²L³/(6EI) by bending and 3F²L/(5GA) by shear, which a clamp that holds the
// cross-section's shape takes a little of.
TEST(PartCheck, StrainEnergyOfACantileverIsBeamTheorys) {
  const PartJob job = cantilever();
  const double force = 200.0, length = 0.06, area = 0.01 * 0.004;
  const double inertia = 0.004 * std::pow(0.01, 3) / 12.0;
  const double bending =
      force * force * std::pow(length, 3) / (6.0 * 210e9 * inertia);
  const double shear =
      3.0 * force * force * length / (5.0 * 210e9 / 2.6 * area);
  constexpr double kClamp = 0.01;
  EXPECT_NEAR(check_part(job).result.strain_energy, bending + shear,
              kClamp * bending);
}

/// It with a model and a limit, to a tolerance that neither meets.
PartJob bent_bar(ModelKind model, int max_dofs) {
  PartJob job = cantilever();
  job.tolerance = 1e-5;
  job.model = model;
  job.max_dofs = max_dofs;
  return job;
}

TEST(PartCheck, DegreesBeyondMaxDofsAreLeftOutAndTold) {
  // 19 × 7 × 4 nodes of degree 3.
  const PartResult result =
      check_part(bent_bar(ModelKind::kSolid, 1595)).result;
  EXPECT_EQ(result.model, "3-D, p = 2");
  EXPECT_EQ(result.dofs, 3 * 13 * 5 * 3);
  EXPECT_EQ(result.verdict, part::Verdict::kNotJudged);
  EXPECT_TRUE(result.stopped_because.starts_with(
      "degree 3 left out, 1596 degrees of freedom, --max-dofs allows 1595: "))
      << result.stopped_because;
  EXPECT_EQ(check_part(bent_bar(ModelKind::kSolid, 1596)).result.dofs, 1596);
}

// What comes from outside of a place is told by the degree before.
TEST(PartCheck, OneDegreeAloneHasNoBand) {
  // 7 × 3 × 2 nodes of degree 1, 13 × 5 × 3 of degree 2.
  const auto peak = [](int max_dofs) {
    PartJob job = pulled_bar();
    job.model = ModelKind::kSolid;
    job.max_dofs = max_dofs;
    return check_part(job).result.peak;
  };
  const PeakStress one = peak(584);
  EXPECT_EQ(one.sequence.size(), 1U);
  EXPECT_EQ(one.band_low, 0.0);
  EXPECT_GE(one.band_high, 2.0 * one.value);
  EXPECT_EQ(one.verdict, PeakVerdict::kNotConverged);
  const PeakStress two = peak(585);
  EXPECT_EQ(two.sequence.size(), 2U);
  EXPECT_GT(two.band_low, 0.5 * two.value);
}

TEST(PartCheck, TwoDegreesAreEnoughForAWideTolerance) {
  const auto peak = [](double tolerance, const auto& change) {
    PartJob job = pulled_bar();
    job.model = ModelKind::kSolid;
    job.tolerance = tolerance;
    change(job.part);
    return check_part(job).result.peak;
  };
  const auto nothing = [](part::PartDefinition&) {};
  const PeakStress wide = peak(0.03, nothing);
  EXPECT_EQ(wide.sequence.size(), 2U);
  EXPECT_TRUE(wide.has_band);
  EXPECT_EQ(wide.verdict, PeakVerdict::kConverged);
  EXPECT_NEAR(wide.value, 10e6, 1.0);
  EXPECT_EQ(peak(0.029, nothing).sequence.size(), 3U);
  // What else is asked for, or hides from two degrees.
  const auto deflection = [](part::PartDefinition& part) {
    part.limits.deflection = 1.0;
  };
  EXPECT_EQ(peak(0.03, deflection).sequence.size(), 3U);
  const auto soft = [](part::PartDefinition& part) {
    part.material.poissons_ratio = 0.45;
  };
  EXPECT_EQ(peak(0.03, soft).sequence.size(), 3U);
}

// The first degrees are solved for the governing instants only; what is told
// is of all.
TEST(PartCheck, MaxDofsEndAPlatesDegreesWithAllInstants) {
  constexpr int kTerms = 2;
  PartJob job = ramped(pulled_bar(), 20);
  job.model = ModelKind::kLayered;
  job.tolerance = 1e-12;  // of an even stress: below its round-off
  job.max_dofs = 6 * kTerms * 25 * 9 - 1;
  const PartAssessment found = check_part(job);
  EXPECT_EQ(found.result.dofs, 6 * kTerms * 19 * 7);
  EXPECT_TRUE(found.result.stopped_because.starts_with("degree 4 left out, "))
      << found.result.stopped_because;
  EXPECT_EQ(found.fields.history.size(), 21U);
  EXPECT_EQ(found.result.peak.label, "t = 2.000000 s");
}

// The model's error keeps the band from the tolerance: no reason to end with a
// degree that has none.
TEST(PartCheck, DegreesRiseWhereTheModelIsBeyondTheTolerance) {
  const PartJob job = pulled_bar();
  const PartShape shape(job);
  ModelSettings settings;
  settings.terms = 2;
  settings.error = 2.0 * job.tolerance;
  const auto model = std::get<FeModel<3>>(layered_model(shape, settings));
  PartSeconds seconds;
  const auto ladder = climb_degrees<3>(job, model, {}, seconds);
  EXPECT_EQ(ladder.sequence.back().degree, model.highest_degree);
  EXPECT_EQ(ladder.ended_by, "");
}

// What tells the error of plane stress has more unknowns than 3-D of degree 2.
TEST(PartCheck, ModelsBeyondMaxDofsAreLeftOutAndTold) {
  PartJob job = bent_bar(ModelKind::kSolid, 13 * 5 * 3 * 3);
  job.load_sets[0].fixed.clear();
  job.load_sets[0].history = pulled_bar().load_sets[0].history;
  job.model.reset();
  const PartResult result = check_part(job).result;
  EXPECT_EQ(result.model, "3-D, p = 2");
  EXPECT_NE(result.stopped_because.find("; plane stress left out, "),
            std::string::npos)
      << result.stopped_because;
}

TEST(PartCheck, NoDegreeWithinMaxDofsIsRefused) {
  try {
    check_part(bent_bar(ModelKind::kSolid, 125));  // degree 1: 7 × 3 × 2 nodes
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "F007");
    EXPECT_EQ(error.problem(), "126 degrees of freedom, --max-dofs allows 125");
  }
}

// Clamped at x0 and bent at x1: beam theory's section is the held one.
TEST(PartCheck, HeldSectionIsBeamTheorys) {
  PartJob job = cantilever();
  job.part.limits.exclude_singular_zones = true;
  const double bent = 6.0 * 200.0 * 0.06 / (0.004 * 0.01 * 0.01);
  const auto check = [&](double allowed, double tolerance = 0.05) {
    job.tolerance = tolerance;
    job.part.limits.safety_factor = 300e6 / allowed;
    return check_part(job).result;
  };
  // The cells at the clamp are many times as large as its zone: the rest of the
  // part passes far below the limit only.
  const PartResult result = check(4.0 * bent);
  ASSERT_TRUE(result.held);
  EXPECT_NEAR(result.held->value, bent, 1e-6 * bent);
  EXPECT_LT(result.held->band_high - result.held->band_low, 1e-6 * bent);
  EXPECT_EQ(result.held->label, "pull");
  EXPECT_EQ(result.beam.peak_stress, result.held->value);
  EXPECT_EQ(result.verdict, part::Verdict::kPass) << result.why;
  ASSERT_FALSE(result.singular_zones.empty());
  for (const ZoneResult& zone : result.singular_zones) {
    EXPECT_GT(zone.exponent_measured.value_or(zone.exponent), 0.0);
  }
  const PartResult failed = check(0.99 * bent);
  EXPECT_EQ(failed.verdict, part::Verdict::kFail);
  EXPECT_TRUE(failed.why.starts_with("nominal stress")) << failed.why;
  // though the elements have not settled beside the edge
  EXPECT_EQ(check(0.99 * bent, 1e-3).verdict, part::Verdict::kFail);
  EXPECT_EQ(check(1.01 * bent, 1e-3).verdict, part::Verdict::kNotJudged);
}

TEST(PartCheck, EvenPressureIsNoStress) {
  PartJob job = pulled_bar();
  auto& loads = job.load_sets[0].history.instants[0].surface_loads;
  loads.clear();
  const Vector3d size(0.06, 0.01, 0.004);
  for (int d = 0; d < 3; ++d) {
    for (const int side : {0, 1}) {
      const Vector3d normal = (2.0 * side - 1.0) * Vector3d::Unit(d);
      Vector3d centre = size / 2;
      centre[d] = side * size[d];
      loads::SurfaceLoad load;
      load.group = std::string(1, "xyz"[d]) + (side == 0 ? "0" : "1");
      load.pressure = 10e6;
      load.total = 10e6 * size.prod() / size[d];
      load.resultant.force = -load.total * normal;
      load.resultant.moment = centre.cross(load.resultant.force);
      loads.push_back(load);
    }
  }
  EXPECT_LT(check_part(job).result.peak.value, 1.0);
}

// K u of a bent slender plate is a small difference of large terms.
TEST(PartCheck, BendingOfASlenderPlateIsSolved) {
  PartJob job = pulled_bar();
  job.mesh = support::structured_mesh<3>(
      {40, 4, 1}, 1, [](const Vector3d& x) -> Vector3d {
        return x.cwiseProduct(Vector3d(0.1, 0.01, 0.002));
      });
  job.load_sets[0].fixed["x0"] = {true, true, true};
  auto& loads = job.load_sets[0].history.instants[0].surface_loads;
  loads.erase(loads.begin());
  loads[0].traction = Vector3d(0, 0, 1e4);
  loads[0].total = 1e4 * 0.01 * 0.002;
  loads[0].resultant.force = Vector3d(0, 0, loads[0].total);
  loads[0].resultant.moment =
      Vector3d(0.1, 0.005, 0.001).cross(loads[0].resultant.force);
  job.tolerance = 1e-3;  // up to degree 4
  const double inertia = 0.01 * std::pow(0.002, 3) / 12;
  const double expected =
      loads[0].total * std::pow(0.1, 3) / (3 * 210e9 * inertia);
  EXPECT_NEAR(check_part(job).result.deflection, expected, 0.02 * expected);
}

/// A ring pressed by a pin of 4 kN, held by its rim's traction.
PartJob eye(double thickness, double tolerance, int layers = 1) {
  PartJob job;
  job.part.name = "eye";
  job.part.material = {"steel", 210e9, 0.3, 7850.0, 300e6};
  job.mesh = support::ring_mesh<3>({.inner = 0.01,
                                    .outer = 0.02,
                                    .thickness = thickness,
                                    .radial = 2,
                                    .angular = 12,
                                    .axial = layers,
                                    .degree = 4});
  job.mass = mesh::mass_properties(job.mesh, 7850.0);
  job.tolerance = tolerance;
  LoadSet set;
  const Vector3d centre(0.0, 0.0, thickness / 2);
  set.history.seats = {{"pin", "x0", loads::SeatKind::kBearing, centre},
                       {"rim", "x1", loads::SeatKind::kTraction, centre}};
  loads::InstantLoad instant;
  instant.label = "pull";
  const Vector3d force(4000.0, 0.0, 0.0);
  instant.wrenches = {{force, Vector3d::Zero()}, {-force, Vector3d::Zero()}};
  set.history.instants.push_back(instant);
  job.load_sets.push_back(set);
  return job;
}

/// By hexahedra of degree 4, seen on a fine lattice.
double fine_peak(const PartJob& job) {
  const LoadSet& set = job.load_sets[0];
  const auto basis = elasticity::solve<3>(
      {job.mesh, job.part.material, set.history, set.fixed, "eye"}, 4);
  return stress::stress_history<3>(basis, job.part.material, 8).largest();
}

// A thick eye: plane stress misses the tolerance and says by how much; terms
// through the thickness meet it. Either band holds what hexahedra give.
TEST(PartCheck, ThickEyeClimbsToTermsThroughTheThickness) {
  PartJob job = eye(0.02, 0.01);
  const PartResult climbed = check_part(job).result;
  EXPECT_EQ(climbed.model.substr(0, 15), "2-D x thickness");
  EXPECT_EQ(climbed.peak.verdict, PeakVerdict::kConverged);
  EXPECT_GT(climbed.peak.model_error, 0.0);
  EXPECT_EQ(climbed.stopped_because.substr(0, 16), "within tolerance");
  job.model = ModelKind::kPlaneStress;
  const PartResult plane = check_part(job).result;
  EXPECT_EQ(plane.peak.verdict, PeakVerdict::kNotConverged);
  EXPECT_GT(plane.peak.discretization_error + plane.peak.model_error,
            0.01 * plane.peak.value);
  const double exact = fine_peak(eye(0.02, 0.01, 3));
  for (const PartResult& result : {climbed, plane}) {
    EXPECT_LE(result.peak.band_low, exact) << result.model;
    EXPECT_GE(result.peak.band_high, exact) << result.model;
  }
}

TEST(PartCheck, ThinEyeStaysAtPlaneStressWithItsMeasuredError) {
  const PartResult result = check_part(eye(0.002, 0.03)).result;
  EXPECT_EQ(result.model.substr(0, 12), "plane stress");
  EXPECT_EQ(result.peak.verdict, PeakVerdict::kConverged);
  EXPECT_GT(result.peak.model_error, 0.0);
  const double half_width =
      result.peak.discretization_error + result.peak.model_error;
  EXPECT_NEAR(std::max(result.peak.band_high - result.peak.value,
                       result.peak.value - result.peak.band_low),
              half_width, 1e-9 * half_width);
}

TEST(PartCheck, LoadOnAFaceCallsForTheSolid) {
  PartJob job = pulled_bar();
  auto& loads = job.load_sets[0].history.instants[0].surface_loads;
  for (const int side : {0, 1}) {
    auto& load = loads[static_cast<std::size_t>(side)];
    load.group = side == 0 ? "z0" : "z1";
    load.traction.setZero();
    load.pressure = 10e6;
    load.total = 10e6 * 0.06 * 0.01;
    load.resultant.force = Vector3d(0, 0, side == 0 ? 1.0 : -1.0) * load.total;
    load.resultant.moment =
        Vector3d(0.03, 0.005, side * 0.004).cross(load.resultant.force);
  }
  EXPECT_EQ(check_part(job).result.model.substr(0, 3), "3-D");
  job.model = ModelKind::kLayered;
  EXPECT_THROW(check_part(job), Error);
}

TEST(PartCheck, LoadAcrossThePlaneCallsForTheSolid) {
  PartJob job = pulled_bar();
  for (auto& load : job.load_sets[0].history.instants[0].surface_loads) {
    load.traction += Vector3d(0, 0, 1e6);
    load.resultant.force = 0.01 * 0.004 * load.traction;
  }
  job.load_sets[0].fixed["x0"] = {true, true, true};
  EXPECT_EQ(check_part(job).result.model.substr(0, 3), "3-D");
}

TEST(PartCheck, SupportAcrossThePlaneCallsForTheSolid) {
  PartJob job = pulled_bar();
  job.load_sets[0].fixed["x0"] = {true, true, false};
  EXPECT_EQ(check_part(job).result.model, "plane stress, p = 4");
  job.load_sets[0].fixed["x0"] = {true, true, true};
  EXPECT_EQ(check_part(job).result.model.substr(0, 3), "3-D");
}

/// A thick ring under pressure in its bore and on its ends.
PartJob squeezed_ring(double in_bore, double on_ends) {
  const support::Annulus shape{.inner = 0.02,
                               .outer = 0.04,
                               .thickness = 0.02,
                               .radial = 3,
                               .angular = 8,
                               .axial = 1};
  PartJob job;
  job.part.name = "ring";
  job.part.material = {"steel", 210e9, 0.3, 7850.0, 300e6};
  job.mesh = support::ring_mesh<3>(shape);
  job.mass = mesh::mass_properties(job.mesh, 7850.0);
  LoadSet set;
  loads::InstantLoad instant;
  instant.label = "squeeze";
  const double ends = std::numbers::pi * (0.04 * 0.04 - 0.02 * 0.02);
  for (const auto& [name, pressure, total, along] :
       {std::tuple{"x0", in_bore, 2 * std::numbers::pi * 0.02 * 0.02, 0.0},
        {"z0", on_ends, ends, 1.0},
        {"z1", on_ends, ends, -1.0}}) {
    loads::SurfaceLoad load;
    load.group = name;
    load.pressure = pressure;
    load.total = pressure * total;
    load.resultant.force = Vector3d(0, 0, along * load.total);
    instant.surface_loads.push_back(load);
  }
  set.history.instants.push_back(instant);
  job.load_sets.push_back(set);
  return job;
}

TEST(PartCheck, RingIsSolvedOnItsMeridian) {
  const PartResult result = check_part(squeezed_ring(60e6, 30e6)).result;
  EXPECT_EQ(result.model.substr(0, 27), "axisymmetric, 1 harmonic, p");
  EXPECT_EQ(result.cells, 3);
  EXPECT_EQ(result.peak.verdict, PeakVerdict::kConverged);
  // Lamé at the bore, with the ends' pressure: r, hoop, axial.
  const double radial = -60e6;
  const double hoop = 60e6 * 5.0 / 3.0;
  const double axial = -30e6;
  const double exact =
      std::sqrt(0.5 * (std::pow(radial - hoop, 2) + std::pow(hoop - axial, 2) +
                       std::pow(axial - radial, 2)));
  EXPECT_NEAR(result.peak.value, exact, 1e-3 * exact);
  EXPECT_LE(result.peak.band_low, exact);
  EXPECT_GE(result.peak.band_high, exact);
}

TEST(PartCheck, RevolutionAskedForMustFit) {
  PartJob ring = squeezed_ring(60e6, 0.0);
  ring.model = ModelKind::kRevolution;
  EXPECT_EQ(check_part(ring).result.model.substr(0, 12), "axisymmetric");
  PartJob bar = pulled_bar();
  bar.model = ModelKind::kRevolution;
  EXPECT_THROW(check_part(bar), Error);
}

}  // namespace
}  // namespace clevis::assessment
