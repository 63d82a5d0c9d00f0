#include "assessment/models/revolution_model.h"

#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "assessment/job/part_zones.h"
#include "elasticity/revolution/revolution_solve.h"
#include "stress/field/stress_history.h"

namespace clevis::assessment {
namespace {

constexpr const ModelTraits& kRevolution = traits_of(ModelKind::kRevolution);

/// Result of solving by Fourier terms, over all load sets.
struct Progress {
  int degree{};         ///< solved last
  int harmonics{};      ///< terms of the series, the most of a load set
  double truncation{};  ///< von Mises of its upper half of orders, largest at
                        ///< all corners and instants [Pa]
};

elasticity::DisplacementBasis<3> solve(
    const mesh::Revolution& solid, const elasticity::ElasticProblem<3>& problem,
    int degree, Progress& progress) {
  auto solution = elasticity::solve_revolution(
      {solid, problem.material, problem.history, problem.fixed, problem.name,
       problem.max_dofs, problem.tell_dofs},
      degree);
  if (progress.degree != degree) progress = {degree, 0, 0.0};
  progress.harmonics = std::max(progress.harmonics, solution.terms);
  if (solution.upper_half.size() > 0) {
    std::swap(solution.basis.columns, solution.upper_half);
    constexpr int kCorners = 1;  // an estimate: at the cells' corners
    const auto rest =
        stress::stress_history<3>(solution.basis, problem.material, kCorners);
    progress.truncation = std::max(progress.truncation, rest.largest());
    std::swap(solution.basis.columns, solution.upper_half);
  }
  return std::move(solution.basis);
}

void tell(const Progress& progress, PartResult& result) {
  result.model = fmt::format(
      "{}, {} harmonic{}, p = {}", kRevolution.name, progress.harmonics,
      progress.harmonics == 1 ? "" : "s", progress.degree);
  if (result.peak.value > 0.0) {
    result.stopped_because += fmt::format(
        "; higher harmonics bring {:.2g} % at most, counted in the first",
        100.0 * progress.truncation / result.peak.value);
  }
}

}  // namespace

std::optional<std::string> why_not_revolution(const PartShape& shape) {
  if (shape.revolution()) return std::nullopt;
  return "the part is no hollow solid of revolution meshed in closed rings, "
         "with loads and supports that go all round";
}

AnyFeModel revolution_model(const PartShape& shape, const ModelSettings&) {
  const mesh::Revolution& solid = *shape.revolution();
  const auto progress = std::make_shared<Progress>();
  FeModel<3> model;
  model.name = kRevolution.name;
  model.mesh = &shape.job().mesh;
  model.cells_in_plane = static_cast<int>(solid.meridian.cells.size());
  model.solve = [&solid, progress](const elasticity::ElasticProblem<3>& problem,
                                   int degree) {
    return solve(solid, problem, degree, *progress);
  };
  model.zones = [&job = shape.job()](const LoadSet& set) {
    return part_zones<3>(job, job.mesh, set);
  };
  model.first_degree = 2;
  model.highest_degree = kRevolution.highest_degree;
  model.subdivisions = 4;
  model.remark = [progress](PartResult& result) {
    tell(*progress, result);
  };
  return model;
}

}  // namespace clevis::assessment
