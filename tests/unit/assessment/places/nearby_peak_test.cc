// The peak of tetrahedra by finer solutions near the places where it may
// stand, against closed forms.

#include "assessment/places/nearby_peak.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "assessment/models/solid_model.h"
#include "assessment/part_check.h"
#include "assessment/places/closer_look.h"
#include "assessment/places/local_solve.h"
#include "assessment/places/meeting_places.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/nodal_loads/load_vectors.h"
#include "mesh/derived/sub_mesh.h"
#include "mesh/quality/mass_properties.h"
#include "stress/peaks/meeting_points.h"
#include "support/annulus_mesh.h"
#include "support/simplex_mesh.h"
#include "support/structured_mesh.h"

namespace clevis::assessment {
namespace {

using Eigen::Vector3d;

const part::Material kSteel{"steel", 210e9, 0.3, 7850.0, 355e6};

PartJob job_of(mesh::PartMesh<3> mesh,
               const std::vector<loads::SurfaceLoad>& loads) {
  PartJob job;
  job.part.name = "part";
  job.part.material = kSteel;
  job.mesh = std::move(mesh);
  job.mass = mesh::mass_properties(job.mesh, kSteel.density);
  job.model = ModelKind::kSolid;
  LoadSet set;
  loads::InstantLoad instant;
  instant.label = "load";
  instant.surface_loads = loads;
  set.history.instants.push_back(instant);
  job.load_sets.push_back(set);
  return job;
}

/// Quarter of a ring, radii 10 and 20 mm, 10 MPa in its bore, cells of all
/// shapes. Lamé: σ_θ = p (a² + b²)/(b² − a²), σ_r = −p, σ_z = 0 at the bore.
constexpr double kInner = 0.01;
constexpr double kOuter = 0.02;
constexpr double kThickness = 0.006;
constexpr double kPressure = 10e6;

PartJob ring(int radial, int angular, double disorder, int order = 4) {
  auto mesh = support::simplex_mesh<3>(
      {radial, angular, 2}, order, [&](const Vector3d& x) -> Vector3d {
        const double bump = disorder * std::sin(std::numbers::pi * x[0]) *
                            std::sin(std::numbers::pi * x[1]);
        const double s = x[0] + bump * std::cos(5.0 * x[1] + 7.0 * x[2]);
        const double t = x[1] + bump * std::sin(6.0 * x[0] + 4.0 * x[2]);
        const double r = kInner + (kOuter - kInner) * s;
        const double angle = 0.5 * std::numbers::pi * t;
        return {r * std::cos(angle), r * std::sin(angle), kThickness * x[2]};
      });
  loads::SurfaceLoad load;
  load.group = "x0";
  load.pressure = kPressure;
  const double push = kPressure * kInner * kThickness;
  load.resultant.force = {push, push, 0.0};
  load.resultant.moment =
      Vector3d(0.0, 0.0, kThickness / 2).cross(load.resultant.force);
  load.total = push * std::numbers::pi / 2;
  auto job = job_of(std::move(mesh), {load});
  job.load_sets[0].fixed = {{"y0", {false, true, false}},
                            {"y1", {true, false, false}},
                            {"z0", {false, false, true}}};
  return job;
}

double lames_peak() {
  const double hoop = kPressure * 5.0 / 3.0;
  return std::sqrt(hoop * hoop + kPressure * kPressure + hoop * kPressure);
}

TEST(NearbyPeak, BandHoldsLamesStressOnIrregularTetrahedra) {
  const double exact = lames_peak();
  int converged = 0;
  for (const double disorder : {0.0, 0.03, 0.05}) {
    for (const int cells : {2, 3}) {
      const PartResult result = check_part(ring(cells, cells, disorder)).result;
      const PeakStress& peak = result.peak;
      std::printf(
          "%d cells, disorder %.2f: %.4f [%.4f, %.4f], exact %.4f; %s\n", cells,
          disorder, peak.value / 1e6, peak.band_low / 1e6, peak.band_high / 1e6,
          exact / 1e6, result.model.c_str());
      EXPECT_LE(peak.band_low, exact);
      EXPECT_GE(peak.band_high, exact);
      EXPECT_TRUE(peak.degree_nearby);
      converged += peak.verdict == PeakVerdict::kConverged ? 1 : 0;
    }
  }
  EXPECT_GE(converged, 3);
}

// Flat faces round the bore: no degree mends that, so that the highest one is
// left out, unless the deflection asks for it.
TEST(NearbyPeak, DegreesEndWhereTheFacesKeepTheBandOpen) {
  PartJob job = ring(2, 12, 0.0, 1);
  job.tolerance = 0.01;
  const PartResult result = check_part(job).result;
  EXPECT_EQ(result.model, "3-D tetrahedra, p = 3");
  EXPECT_TRUE(result.stopped_because.starts_with(
      "degree 4 left out, finer cells are wanted"))
      << result.stopped_because;
  EXPECT_EQ(result.peak.verdict, PeakVerdict::kNotConverged);
  EXPECT_LE(result.peak.band_low, lames_peak());
  EXPECT_GE(result.peak.band_high, lames_peak());
  job.part.limits.deflection = result.deflection;
  const PartResult deflected = check_part(job).result;
  EXPECT_EQ(deflected.model, "3-D tetrahedra, p = 4");
  EXPECT_TRUE(deflected.stopped_because.starts_with("highest degree done"))
      << deflected.stopped_because;
}

/// Local against whole: stress near some cells of the ring.
void expect_local_is_whole(const PartJob& job, const std::vector<int>& centre) {
  PartSeconds seconds;
  const auto level = solve_level<3>(job, job.load_sets, job.mesh,
                                    solid_model(job.mesh), 2, seconds);
  const auto& basis = *level.governing;
  const LoadSet& set = job.load_sets[0];
  const auto some =
      solve_nearby<3>(job, set, job.mesh, basis, {centre, 1, 0, 3});
  const auto fine = elasticity::discretize<3>(job.mesh, 3);
  const Eigen::MatrixXd load =
      elasticity::assemble_loads<3>(fine, set.history, kSteel.density, "part");
  const auto all = elasticity::enrich<3>(
      {basis.discretization, basis.columns * basis.coefficients, fine, load,
       elasticity::held_on_groups<3>(fine, set.fixed), kSteel},
      mesh::surroundings(job.mesh, centre, 1));
  ASSERT_EQ(some.cells, all.cells);
  ASSERT_LT(some.cells.size(), job.mesh.cells.size() / 2);
  const auto a = stress::joined_stress<3>(some.basis, kSteel, 4);
  const auto b = stress::joined_stress<3>(all.basis, kSteel, 4);
  EXPECT_LT((a.mean - b.mean).cwiseAbs().maxCoeff(), 1e-8 * lames_peak());
  EXPECT_GT(a.mean.maxCoeff(), 0.9 * lames_peak());
}

// What stands far from the neighbourhood needs no discretisation, but the
// loaded groups do, whole: as with the whole mesh.
TEST(LocalSolve, OnSomeCellsIsThatOnAllOfThem) {
  expect_local_is_whole(ring(3, 6, 0.05), {0, 3});
}

/// The first cell turned by half a turn about its third direction.
void turn_first_cell(mesh::PartMesh<3>& mesh) {
  const auto turned = [](auto& values, int n) {
    const auto old = values;
    for (int k = 0; k < n * n * n; ++k) {
      const int layer = n * n * (k / (n * n));
      values[k] = old[layer + n * n - 1 - k % (n * n)];
    }
  };
  turned(mesh.cells[0], 2);
  std::vector<Vector3d> points;
  for (const auto& point : mesh.cell_points[0].colwise()) {
    points.emplace_back(point);
  }
  turned(points, mesh.degree + 1);
  for (std::size_t k = 0; k < points.size(); ++k) {
    mesh.cell_points[0].col(static_cast<Eigen::Index>(k)) = points[k];
  }
  for (mesh::BoundaryFace& face : mesh.boundary) {
    if (face.cell == 0 && face.face < 4) face.face ^= 1;
  }
}

// Of hexahedra, too; where one cell turns those of its row, a few alone would
// stay as they are.
TEST(LocalSolve, OnSomeHexahedraIsThatOnAllOfThem) {
  // From outside inwards: the first cell is far from the loaded bore.
  const auto bent = [](const Vector3d& x) -> Vector3d {
    const double r = kOuter - (kOuter - kInner) * x[0];
    const double angle = 0.5 * std::numbers::pi * (1.0 - x[1]);
    return {r * std::cos(angle), r * std::sin(angle), kThickness * x[2]};
  };
  PartJob job = ring(1, 1, 0.0);
  job.mesh = support::structured_mesh<3>({5, 8, 2}, 4, bent);
  job.mass = mesh::mass_properties(job.mesh, kSteel.density);
  job.load_sets[0].history.instants[0].surface_loads[0].group = "x1";
  auto& fixed = job.load_sets[0].fixed;
  std::swap(fixed.at("y0"), fixed.at("y1"));
  const std::vector<int> at_bore = {4, 44};
  expect_local_is_whole(job, at_bore);
  turn_first_cell(job.mesh);
  expect_local_is_whole(job, at_bore);
}

// Left where no band can come within the tolerance; else what is found is the
// same.
TEST(NearbyPeak, IsLeftOnlyWhereItCannotConverge) {
  const PartJob job = ring(2, 2, 0.03);
  PartSeconds seconds;
  const auto level = solve_level<3>(job, job.load_sets, job.mesh,
                                    solid_model(job.mesh), 2, seconds);
  const auto look = [&](double tolerance, PlaceSearch which) {
    return nearby_peak<3>(job, job.load_sets, job.mesh, level, level.histories,
                          0.0, tolerance, which)
        .peak;
  };
  constexpr double kWide = 0.5, kUnmet = 1e-9;
  const auto all = look(kWide, PlaceSearch::kAll);
  const auto some = look(kWide, PlaceSearch::kWhileItMayConverge);
  ASSERT_TRUE(all && some);
  EXPECT_EQ(all->band.verdict, stress::Convergence::kConverged);
  EXPECT_EQ(some->band.verdict, all->band.verdict);
  EXPECT_EQ(some->band.value, all->band.value);
  EXPECT_EQ(some->band.low, all->band.low);
  EXPECT_EQ(some->band.high, all->band.high);
  EXPECT_FALSE(look(kUnmet, PlaceSearch::kWhileItMayConverge));
}

// Of what it knows before its dearest solution a look asks whether that is
// worth it: left out it counts as far off as the degree, and the band holds.
TEST(CloserLook, GoesOnAsLongAsItIsWorthIt) {
  const PartJob job = ring(2, 2, 0.03);
  PartSeconds seconds;
  const auto level = solve_level<3>(job, job.load_sets, job.mesh,
                                    solid_model(job.mesh), 2, seconds);
  const SolvedSet<3> solved{job,
                            job.load_sets[0],
                            job.mesh,
                            *level.governing,
                            level.history(),
                            level.member.degree};
  const auto found = find_places<3>(level.governing->discretization,
                                    level.history(), 0.9 * lames_peak());
  const Place& place = found.places.front();
  auto centre = found.cells[static_cast<std::size_t>(place.number)];
  std::ranges::sort(centre);
  std::vector<KnownOfPlace> asked;
  const auto look = [&](Worth before, Worth after) {
    asked.clear();
    return look_closer<3>(solved, place, centre, 0.0,
                          [&](const KnownOfPlace& known) {
                            asked.push_back(known);
                            return known.estimate ? after : before;
                          });
  };
  EXPECT_FALSE(look(Worth::kNothing, Worth::kMore));
  EXPECT_EQ(asked.size(), 1u);
  EXPECT_FALSE(look(Worth::kMore, Worth::kNothing));
  ASSERT_EQ(asked.size(), 2u);
  const KnownOfPlace known = asked.back();
  const auto guessed = look(Worth::kMore, Worth::kEnough);
  const auto solved_for = look(Worth::kMore, Worth::kMore);
  ASSERT_TRUE(guessed && solved_for);
  EXPECT_EQ(guessed->stress.value, known.estimate->value);
  EXPECT_NE(solved_for->stress.value, known.estimate->value);
  EXPECT_LE(known.error, solved_for->stress.high - solved_for->stress.value);
  for (const auto& band : {guessed->stress, solved_for->stress}) {
    EXPECT_LE(band.low, lames_peak());
    EXPECT_GE(band.high, lames_peak());
    EXPECT_LT(band.high - band.low, 0.2 * lames_peak());
  }
}

/// A traction of 10 MPa that pulls on both ends of a prism along an axis.
/// @param area  of an end [m²].
/// @param low, high  centroids of the ends [m].
std::vector<loads::SurfaceLoad> pull(char axis, double area,
                                     const Vector3d& low,
                                     const Vector3d& high) {
  std::vector<loads::SurfaceLoad> loads;
  for (const int end : {0, 1}) {
    loads::SurfaceLoad load;
    load.group = axis + std::to_string(end);
    load.traction = Vector3d::Zero();
    load.traction[axis - 'x'] = end == 0 ? -10e6 : 10e6;
    load.resultant.force = area * load.traction;
    load.resultant.moment = (end == 0 ? low : high).cross(load.resultant.force);
    loads.push_back(load);
  }
  return loads;
}

// Nothing of a uniform pull along a tube's facets is in doubt but what stands
// between them and the round surfaces: three times its share of the energy,
// which is that of the volume.
TEST(NearbyPeak, CountsTheEnergyBetweenFacetsAndTheirSurface) {
  constexpr int kCells = 9;
  const double angle = std::numbers::pi / 2 / kCells;
  const double area =
      0.5 * kCells * std::sin(angle) * (kOuter * kOuter - kInner * kInner);
  const double segments = 0.5 * kCells * (angle - std::sin(angle)) *
                          (kOuter * kOuter + kInner * kInner);
  Vector3d centroid = Vector3d::Zero();
  for (int cell = 0; cell < kCells; ++cell) {
    const double middle = (cell + 0.5) * angle;
    centroid += std::sin(angle) * std::cos(0.5 * angle) / 3.0 *
                (std::pow(kOuter, 3) - std::pow(kInner, 3)) / area *
                Vector3d(std::cos(middle), std::sin(middle), 0.0);
  }
  auto job = job_of(
      support::sector_mesh<3>({.inner = kInner,
                               .outer = kOuter,
                               .thickness = kThickness,
                               .radial = 2,
                               .angular = kCells,
                               .degree = 1}),
      pull('z', area, centroid, centroid + kThickness * Vector3d::UnitZ()));
  job.tolerance = 0.1;
  const auto peak = check_part(job).result.peak;
  const double wanted = 3.0 * segments / area * 10e6;
  EXPECT_NEAR(peak.value, 10e6, 10.0);
  EXPECT_NEAR(peak.band_high - peak.value, wanted, 0.03 * wanted);
  EXPECT_NEAR(peak.value - peak.band_low, wanted, 0.03 * wanted);
}

// Of columns five times as long as wide more than one layer.
TEST(LocalSolve, ReachesPastSlenderCells) {
  constexpr double kSide = 9e-3, kLength = 5e-3;
  const Vector3d middle(kSide / 2, kSide / 2, 0.0);
  const PartJob job = job_of(
      support::structured_mesh<3>(
          {9, 9, 1}, 1,
          [](const Vector3d& x) -> Vector3d {
            return {kSide * x[0], kSide * x[1], kLength * x[2]};
          }),
      pull('z', kSide * kSide, middle, middle + kLength * Vector3d::UnitZ()));
  PartSeconds seconds;
  const auto level = solve_level<3>(job, job.load_sets, job.mesh,
                                    solid_model(job.mesh), 1, seconds);
  for (const int layers : {1, 2}) {
    const auto near = solve_nearby<3>(job, job.load_sets[0], job.mesh,
                                      *level.governing, {{0}, layers, 0, 2});
    EXPECT_EQ(near.cells, mesh::surroundings(job.mesh, {0}, layers));
    EXPECT_GT(near.cells.size(),
              mesh::with_neighbours(job.mesh, {0}, layers).size());
  }
}

// A uniform stress is in every space: nothing is in doubt.
TEST(NearbyPeak, OfAFieldInTheSpaceHasNoError) {
  auto mesh = support::simplex_mesh<3>({3, 2, 2}, 1, [](const Vector3d& x) {
    const double bump = 0.3 * x[0] * (1.0 - x[0]) * x[1] * (1.0 - x[1]);
    return Vector3d(0.03 * (x[0] + bump), 0.01 * (x[1] - bump), 0.01 * x[2]);
  });
  const auto loads = pull('x', 0.01 * 0.01, Vector3d(0.0, 0.005, 0.005),
                          Vector3d(0.03, 0.005, 0.005));
  const auto peak = check_part(job_of(std::move(mesh), loads)).result.peak;
  EXPECT_EQ(peak.verdict, PeakVerdict::kConverged);
  EXPECT_NEAR(peak.value, 10e6, 10.0);
  EXPECT_LT(peak.band_high - peak.band_low, 1e-5 * 10e6);
  EXPECT_LE(peak.band_low, peak.value);
  EXPECT_GE(peak.band_high, peak.value);
  EXPECT_LT(peak.jump, 10.0);
}

// A bar of one hexahedron across, bent about one axis and then nearly as much
// about the other: what stresses one side of a cell later says nothing of what
// the other bears now.
TEST(NearbyPeak, RisesPointByPointToAnotherInstant) {
  const Vector3d size(0.06, 0.01, 0.01);
  PartJob job =
      job_of(support::structured_mesh<3>({6, 1, 1}, 1,
                                         [&](const Vector3d& x) -> Vector3d {
                                           return size.cwiseProduct(
                                               x - Vector3d(0.0, 0.5, 0.5));
                                         }),
             {});
  auto& history = job.load_sets[0].history;
  history.instants.clear();
  for (const double at : {0.0, size.x()}) {
    history.seats.push_back({.name = at > 0.0 ? "end" : "root",
                             .group = at > 0.0 ? "x1" : "x0",
                             .kind = loads::SeatKind::kTraction,
                             .p_LS = Vector3d(at, 0.0, 0.0)});
  }
  for (const Vector3d& moment : {Vector3d(0, 0, 10.0), Vector3d(0, 9.5, 0)}) {
    loads::InstantLoad instant;
    instant.time = static_cast<double>(history.instants.size());
    instant.label = "bent";
    instant.wrenches = {{Vector3d::Zero(), -moment},
                        {Vector3d::Zero(), moment}};
    history.instants.push_back(instant);
  }
  const double exact = 10.0 * 6.0 / std::pow(size.y(), 3);
  const PeakStress peak = check_part(job).result.peak;
  constexpr double kRoundOff = 1e-9;
  EXPECT_NEAR(peak.value, exact, 0.01 * exact);
  EXPECT_LE(peak.band_low, (1.0 + kRoundOff) * exact);
  EXPECT_GE(peak.band_high, (1.0 - kRoundOff) * exact);
}

}  // namespace
}  // namespace clevis::assessment
