#include "elasticity/vibration/load_vibration.h"

#include "dynamics/systems/block_krylov.h"
#include "dynamics/systems/held_system.h"
#include "elasticity/algebra/dense_product.h"
#include "elasticity/algebra/principal_columns.h"
#include "elasticity/problem/elastic_problem.h"
#include "elasticity/solid/solid_solve.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double kSame = 0.02;  // of the energy norm
constexpr Index kMost = 12;

}  // namespace

template <int dim>
LoadVibration<dim>::LoadVibration(const ElasticProblem<dim>& problem,
                                  int degree, const std::vector<Index>& driving)
    : statics_(solve(problem, degree)), part_(vibrating_part(problem, degree)) {
  const auto& system = part_.system;
  MatrixXd answers = restrict_rows(statics_.columns, part_.numbers);
  if (part_.held.cols() > 0) {
    answers = dynamics::moved_to_constraints(part_.free, part_.held, answers);
  }
  weighted_ = system.mass(answers);
  if (system.rigid.cols() > 0) {
    const MatrixXd rigid = dynamics::mass_orthonormal(system, system.rigid);
    answers -= product(rigid, transposed_product(rigid, weighted_));
  }
  MatrixXd at(statics_.coefficients.rows(), static_cast<Index>(driving.size()));
  for (Index i = 0; i < at.cols(); ++i) {
    at.col(i) = statics_.coefficients.col(driving[static_cast<std::size_t>(i)]);
  }
  const MatrixXd gram = transposed_product(answers, system.stiffness(answers));
  const MatrixXd combinations =
      principal_columns(0.5 * (gram + gram.transpose()), at, kSame, kMost)
          .combinations;
  driving_loads_ = combinations.cols();
  space_ = std::make_unique<dynamics::LoadShapes>(
      system, product(answers, combinations));
}

template <int dim>
typename LoadVibration<dim>::Shapes LoadVibration<dim>::shapes(int count) {
  const auto found = space_->shapes(count);
  return {extend_rows(found.columns, part_.numbers), found.squares,
          transposed_product(found.columns, weighted_)};
}

template class LoadVibration<2>;
template class LoadVibration<3>;

}  // namespace clevis::elasticity
