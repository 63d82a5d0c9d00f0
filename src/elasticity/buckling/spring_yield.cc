#include "elasticity/buckling/spring_yield.h"

#include <algorithm>
#include <cstddef>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include "elasticity/algebra/dense_product.h"
#include "elasticity/nodal_loads/seat_means.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double kRoundOff = 1e-9;

}  // namespace

SpringYield::SpringYield(const BucklingProblem& problem, const MatrixXd& rigid)
    : history_(problem.history) {
  constexpr std::size_t kMost = 65;
  const std::size_t all = history_.instants.size();
  if (!history_.hold || rigid.cols() == 0) return;
  const std::size_t count = std::min(kMost, all);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = count == 1 ? 0 : k * (all - 1) / (count - 1);
    if (history_.hold(history_.instants[i].time).sprung.cols() == 0) continue;
    instants_.push_back(static_cast<Index>(i));
  }
  if (instants_.empty()) return;
  motions_ = transposed_product(
      seat_means(problem.discretization, history_.seats, {}, problem.name),
      rigid);
}

double SpringYield::at(Index instant, const MatrixXd& form) const {
  const loads::SeatHold hold =
      history_.hold(history_.instants[static_cast<std::size_t>(instant)].time);
  MatrixXd left = MatrixXd::Identity(motions_.cols(), motions_.cols());
  if (hold.held.cols() > 0) {
    const MatrixXd rows =
        hold.held.colwise().normalized().transpose() * motions_;
    Eigen::JacobiSVD<MatrixXd> svd(rows, Eigen::ComputeFullV);
    svd.setThreshold(kRoundOff);
    left = svd.matrixV().rightCols(rows.cols() - svd.rank());
  }
  if (left.cols() == 0) return 0.0;
  const MatrixXd springs = hold.sprung.transpose() * motions_ * left;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> stiffness(springs.transpose() *
                                                          springs);
  const Eigen::VectorXd& values = stiffness.eigenvalues();
  const Index sprung = (values.array() > kRoundOff * values.maxCoeff()).count();
  if (sprung == 0) return 0.0;
  const MatrixXd unit =
      left * stiffness.eigenvectors().rightCols(sprung) *
      values.tail(sprung).cwiseSqrt().cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> pushed(
      unit.transpose() * form * unit, Eigen::EigenvaluesOnly);
  return std::max(0.0, pushed.eigenvalues().maxCoeff());
}

}  // namespace clevis::elasticity
