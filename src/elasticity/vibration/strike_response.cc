#include "elasticity/vibration/strike_response.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "base/values/stopwatch.h"
#include "elasticity/algebra/dense_product.h"
#include "elasticity/nodal_loads/load_basis.h"
#include "elasticity/problem/elastic_problem.h"
#include "elasticity/vibration/vibrating_part.h"

namespace clevis::elasticity {
namespace {

using Eigen::MatrixXd;

/// Of displacements as columns, over the largest instant.
constexpr double kCompressionTolerance = 1e-6;

template <int dim>
void require_direction(const loads::Strike& strike, const std::string& place) {
  const double normal = dim == 2 ? std::abs(strike.direction.z()) : 0.0;
  if (std::abs(strike.direction.norm() - 1.0) < 1e-9 && normal < 1e-9) return;
  throw Error("F006", place,
              fmt::format("strike \"{}\": direction ({:.4g}, {:.4g}, {:.4g})",
                          strike.name, strike.direction.x(),
                          strike.direction.y(), strike.direction.z()),
              dim == 2 ? "A plate in plane stress is struck in its plane."
                       : "Give a unit vector.");
}

}  // namespace

template <int dim>
struct StruckFace<dim>::Model {
  Model(const ElasticProblem<dim>& problem, const std::string& group,
        const Eigen::Vector3d& direction, int degree)
      : place("part " + problem.name),
        part(vibrating_part(problem, degree)),
        contact(unit_load(part, group, direction, place)),
        shapes(part.system, contact) {}

  std::string place;
  VibratingPart<dim> part;
  Eigen::VectorXd contact;
  dynamics::ExcitedShapes shapes;
  double seconds{};  ///< of the matrices, until the first strike
};

template <int dim>
StruckFace<dim>::StruckFace(const ElasticProblem<dim>& problem,
                            const std::string& group,
                            const Eigen::Vector3d& direction, int degree) {
  Stopwatch watch;
  model_ = std::make_unique<Model>(problem, group, direction, degree);
  model_->seconds = watch.lap();
}

template <int dim>
StruckFace<dim>::~StruckFace() = default;

template <int dim>
StrikeResponse<dim> StruckFace<dim>::solve(
    const loads::Strike& strike, const dynamics::StrikeOptions& options) {
  require_direction<dim>(strike, model_->place);
  Stopwatch watch;
  const auto& part = model_->part;
  StrikeResponse<dim> response;
  response.assemble_seconds = std::exchange(model_->seconds, 0.0);
  response.solution =
      dynamics::solve_strike(part.system, model_->contact, model_->shapes,
                             strike, options, model_->place);
  auto& solution = response.solution;
  DisplacementBasis<dim>& basis = response.basis;
  if (solution.is_modal) {
    basis.columns = extend_rows(solution.columns, part.numbers);
    basis.coefficients = std::move(solution.run.states);
  } else {
    const LoadBasis few = compress(solution.run.states, kCompressionTolerance);
    basis.columns = extend_rows(few.columns, part.numbers);
    basis.coefficients = few.coefficients;
    basis.checks.compression = few.compression_error;
  }
  solution.columns.resize(0, 0);
  solution.run.states.resize(0, 0);
  basis.equations = part.numbers.count;
  basis.strain_energy = solution.run.strain_energy;
  response.solve_seconds = watch.lap();
  basis.seconds = {response.assemble_seconds, 0.0, response.solve_seconds};
  response.stiffness = 1.0 / solution.contact_compliance;
  response.mass = part.mass;
  basis.discretization = part.discretization;
  return response;
}

template <int dim>
StrikeResponse<dim> solve_strike(const ElasticProblem<dim>& problem,
                                 const loads::Strike& strike, int degree,
                                 const dynamics::StrikeOptions& options) {
  require_direction<dim>(strike, "part " + problem.name);
  return StruckFace<dim>(problem, strike.group, strike.direction, degree)
      .solve(strike, options);
}

template class StruckFace<2>;
template class StruckFace<3>;
template StrikeResponse<2> solve_strike<2>(const ElasticProblem<2>&,
                                           const loads::Strike&, int,
                                           const dynamics::StrikeOptions&);
template StrikeResponse<3> solve_strike<3>(const ElasticProblem<3>&,
                                           const loads::Strike&, int,
                                           const dynamics::StrikeOptions&);

}  // namespace clevis::elasticity
