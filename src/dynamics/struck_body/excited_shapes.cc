#include "dynamics/struck_body/excited_shapes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>

#include "base/messages/errors.h"

namespace clevis::dynamics {

using Eigen::MatrixXd;
using Eigen::VectorXd;

ExcitedShapes::ExcitedShapes(const LinearSystem& system, const VectorXd& load)
    : system_(system),
      load_(load),
      rigid_(mass_orthonormal(system, system.rigid)) {
  const BlockOperator solve = system.factor(system.least_shift());
  // Of a free body the part of the load that moves it as a whole is taken
  // out: what is left strains it.
  VectorXd straining = load;
  if (rigid_.cols() > 0) {
    straining -= system.mass(rigid_ * (rigid_.transpose() * load));
  }
  const MatrixXd answer = solve(straining);
  compliance_ = load.dot(answer.col(0));
  if (!(compliance_ > 0.0)) {
    throw Error("F006", "strike",
                "what is struck cannot move in the direction of the blow: the "
                "part's supports hold it",
                "Strike a face that gives way, or change `fixed`.");
  }
  space_ = std::make_unique<BlockKrylov>(system, solve, answer, rigid_);
}

void ExcitedShapes::project() {
  const auto basis = space_->basis();
  const Eigen::Index before = stiffness_.cols();
  const Eigen::Index added = basis.cols() - before;
  if (added == 0) return;
  const MatrixXd image = system_.stiffness(basis.rightCols(added));
  const MatrixXd components = basis.transpose() * image;
  stiffness_.conservativeResize(basis.cols(), basis.cols());
  stiffness_.rightCols(added) = components;
  stiffness_.bottomLeftCorner(added, before) =
      components.topRows(before).transpose();
}

ReducedModel ExcitedShapes::model(int vectors) {
  while (space_->size() < vectors && !space_->is_closed()) {
    space_->extend();
    ++solves_;
  }
  project();
  const Eigen::Index n = std::min<Eigen::Index>(vectors, space_->size());
  const MatrixXd stiffness = stiffness_.topLeftCorner(n, n);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> modes(
      0.5 * (stiffness + stiffness.transpose()));
  const VectorXd load = modes.eigenvectors().transpose() *
                        (space_->basis().leftCols(n).transpose() * load_);
  // Round-off brings shapes into the space that the load does not excite, slow
  // ones first.
  constexpr double kNothing = 1e-9;
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < n; ++i) {
    if (std::abs(load[i]) > kNothing * load.cwiseAbs().maxCoeff()) {
      kept.push_back(i);
    }
  }
  ReducedModel result;
  const auto count = static_cast<Eigen::Index>(kept.size());
  result.in_space = modes.eigenvectors()(Eigen::all, kept);
  result.squares = VectorXd::Zero(rigid_.cols() + count);
  result.squares.tail(count) = modes.eigenvalues()(kept);
  result.contact.resize(rigid_.cols() + count);
  result.contact << rigid_.transpose() * load_, VectorXd(load(kept));
  result.is_complete = space_->is_closed() && n == space_->size();
  return result;
}

MatrixXd ExcitedShapes::shapes(const ReducedModel& model) const {
  MatrixXd result(system_.size, model.squares.size());
  result << rigid_,
      space_->basis().leftCols(model.in_space.rows()) * model.in_space;
  return result;
}

}  // namespace clevis::dynamics
