#include "assessment/sharing/rough_answers.h"

#include <variant>
#include <vector>

#include "assessment/models/level.h"
#include "assessment/models/model_list.h"
#include "elasticity/problem/displacement_basis.h"
#include "stress/displacement/touched_reference.h"
#include "stress/field/stress_history.h"
#include "stress/zones/singular_zone.h"
#include "stress/zones/zone_mask.h"

namespace clevis::assessment {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int kSubdivisions = 4;
constexpr int kPlaneDegree = 3;
constexpr int kDegree = 2;
constexpr int kTerms = 3;

template <int dim>
VectorXd deflections(elasticity::DisplacementBasis<dim> basis,
                     const LoadSet& set) {
  if (set.fixed.empty() && set.foundations.empty()) {
    stress::refer_to_holds<dim>(set.history, reference_hold(set), basis);
  }
  VectorXd largest(basis.coefficients.cols());
  for (Index i = 0; i < largest.size(); ++i) {
    const VectorXd u = basis.columns * basis.coefficients.col(i);
    largest[i] = u.reshaped(dim, u.size() / dim).colwise().norm().maxCoeff();
  }
  return largest;
}

template <int dim>
RoughAnswers answers_of(const PartJob& job, const LoadSet& set,
                        const std::vector<stress::SingularZone>& zones,
                        const elasticity::DisplacementBasis<dim>& basis) {
  const auto zone_of =
      stress::zone_of_points<dim>(basis.discretization, kSubdivisions, zones);
  return {stress::peaks_outside<dim>(basis, job.part.material, kSubdivisions,
                                     zone_of),
          deflections<dim>(basis, set)};
}

}  // namespace

RoughPeak largest_of(const RoughAnswers& answers, Index first, Index count) {
  if (count == 0) return {};
  return {answers.stress.segment(first, count).maxCoeff(),
          answers.deflection.segment(first, count).maxCoeff()};
}

RoughAnswers rough_answers(const PartJob& job, const LoadSet& set) {
  PartJob alone;
  alone.part = job.part;
  alone.mesh = job.mesh;
  alone.load_sets = {set};
  alone.engine = job.engine;
  alone.is_shared = job.is_shared;
  const PartShape shape(alone);
  const auto answers = [&]<int dim>(const FeModel<dim>& model) {
    const auto basis = model.solve({.mesh = *model.mesh,
                                    .material = job.part.material,
                                    .history = set.history,
                                    .fixed = set.fixed,
                                    .name = job.part.name,
                                    .foundations = set.foundations,
                                    .engine = job.engine,
                                    .is_shared = job.is_shared},
                                   dim == 2 ? kPlaneDegree : kDegree);
    return answers_of<dim>(job, set, model.zones(set), basis);
  };
  return std::visit(answers, cheapest_for_many_instants(shape).make(
                                 shape, {.terms = kTerms}));
}

}  // namespace clevis::assessment
