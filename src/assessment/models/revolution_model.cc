#include "assessment/models/revolution_model.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/errors.h"
#include "elasticity/problem/elastic_problem.h"
#include "elasticity/revolution/revolution_solve.h"
#include "stress/stress_history.h"

namespace clevis::assessment {
namespace {

constexpr int kLowestDegree = 2;
constexpr int kHighestDegree = 4;
constexpr int kSubdivisions = 4;

bool has_faces(const mesh::PartMesh<2>& meridian, const std::string& name) {
  const auto found =
      std::ranges::find(meridian.groups, name, &mesh::SurfaceGroup::name);
  if (found == meridian.groups.end()) return false;
  const auto index = static_cast<int>(found - meridian.groups.begin());
  return std::ranges::any_of(meridian.boundary, [&](const auto& face) {
    return face.group == index;
  });
}

bool fits(const mesh::Revolution& solid, const PartJob& job) {
  const auto known = [&](const auto& entry) {
    return has_faces(solid.meridian, entry.group);
  };
  const auto known_seat = [&](const loads::Seat& seat) {
    const bool is_patch = seat.slide && seat.kind != loads::SeatKind::kBearing;
    return known(seat) && !is_patch;  // which goes round nothing
  };
  return std::ranges::all_of(job.load_sets, [&](const LoadSet& set) {
    return std::ranges::all_of(set.history.seats, known_seat) &&
           std::ranges::all_of(set.history.instants.front().surface_loads,
                               known) &&
           set.foundations.empty() &&
           std::ranges::all_of(set.fixed,
                               [&](const auto& f) {
                                 return has_faces(solid.meridian, f.first);
                               }) &&
           elasticity::supports_fit(solid, set.fixed);
  });
}

}  // namespace

std::optional<mesh::Revolution> revolution_model(const PartJob& job) {
  const bool is_asked_for = job.model == ModelChoice::kRevolution;
  if (!is_asked_for && job.model != ModelChoice::kAuto) return std::nullopt;
  auto solid = mesh::find_revolution(job.mesh);
  if (solid && fits(*solid, job)) return solid;
  if (is_asked_for) {
    throw Error("F005", "part " + job.part.name,
                "the part is no hollow solid of revolution meshed in closed "
                "rings, with loads and supports that go all round",
                "leave --model out");
  }
  return std::nullopt;
}

Rung<3> revolution_rung(const mesh::Revolution& solid,
                        std::shared_ptr<RevolutionProgress> progress) {
  Rung<3> rung;
  rung.name = "axisymmetric";
  rung.solve = [&solid, progress](const elasticity::ElasticProblem<3>& problem,
                                  int degree) {
    auto solution = elasticity::solve_revolution(
        {solid, problem.material, problem.history, problem.fixed, problem.name},
        degree);
    if (progress->degree != degree) *progress = {degree, 0, 0.0};
    progress->harmonics = std::max(progress->harmonics, solution.terms);
    if (solution.upper_half.size() > 0) {
      std::swap(solution.basis.columns, solution.upper_half);
      constexpr int kCorners = 1;  // an estimate: at the cells' corners
      const auto rest =
          stress::stress_history<3>(solution.basis, problem.material, kCorners);
      progress->truncation = std::max(progress->truncation, rest.largest());
      std::swap(solution.basis.columns, solution.upper_half);
    }
    return std::move(solution.basis);
  };
  rung.first_degree = kLowestDegree;
  rung.highest_degree = kHighestDegree;
  rung.subdivisions = kSubdivisions;
  return rung;
}

}  // namespace clevis::assessment
