#include "elasticity/vibration/load_vibration.h"

#include <cmath>

#include <Eigen/Eigenvalues>

#include "dynamics/systems/block_krylov.h"
#include "elasticity/algebra/dense_product.h"
#include "elasticity/problem/elastic_problem.h"
#include "elasticity/solid/solid_solve.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kSame = 0.02;  // of the energy norm
constexpr Index kMost = 12;

/// Few combinations of the columns of U (their energies' Gram matrix given)
/// that make up what they are at some instants.
MatrixXd principal_combinations(const MatrixXd& gram,
                                const MatrixXd& coefficients) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> metric(gram);
  const double floor = 1e-12 * metric.eigenvalues().maxCoeff();
  const VectorXd root = metric.eigenvalues().cwiseMax(floor).cwiseSqrt();
  const MatrixXd in_energy =
      root.asDiagonal() * metric.eigenvectors().transpose() * coefficients;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> principal(
      in_energy * in_energy.transpose());
  const double wanted = kSame * in_energy.colwise().norm().maxCoeff();
  MatrixXd kept(gram.rows(), 0), rest = in_energy;
  for (Index k = gram.rows(); k-- > 0 && kept.cols() < kMost;) {
    const bool is_small = rest.colwise().norm().maxCoeff() <= wanted;
    if (is_small && kept.cols() > 0) break;
    const VectorXd direction = principal.eigenvectors().col(k);
    rest -= direction * (direction.transpose() * rest);
    kept.conservativeResize(Eigen::NoChange, kept.cols() + 1);
    kept.rightCols<1>() = direction;
  }
  return metric.eigenvectors() * root.cwiseInverse().asDiagonal() * kept;
}

}  // namespace

template <int dim>
LoadVibration<dim>::LoadVibration(const ElasticProblem<dim>& problem,
                                  int degree, const std::vector<Index>& driving)
    : statics_(solve(problem, degree)), part_(vibrating_part(problem, degree)) {
  const auto& system = part_.system;
  MatrixXd answers = restrict_rows(statics_.columns, part_.numbers);
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
      principal_combinations(0.5 * (gram + gram.transpose()), at);
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
