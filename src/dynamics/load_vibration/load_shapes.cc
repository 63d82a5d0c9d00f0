#include "dynamics/load_vibration/load_shapes.h"

#include <Eigen/Eigenvalues>

namespace clevis::dynamics {

using Eigen::MatrixXd;

LoadShapes::LoadShapes(const LinearSystem& system, const MatrixXd& answers)
    : system_(system) {
  const MatrixXd rigid = mass_orthonormal(system, system.rigid);
  const BlockOperator solve = system.factor(system.least_shift());
  space_ = std::make_unique<BlockKrylov>(system, solve, answers, rigid);
}

LoadShapes::Shapes LoadShapes::shapes(int count) {
  while (space_->size() < count && !space_->is_closed()) space_->extend();
  const MatrixXd basis = space_->basis();
  const MatrixXd stiffness = basis.transpose() * system_.stiffness(basis);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> modes(
      0.5 * (stiffness + stiffness.transpose()));
  return {basis * modes.eigenvectors(), modes.eigenvalues()};
}

}  // namespace clevis::dynamics
