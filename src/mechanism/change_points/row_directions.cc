#include "mechanism/change_points/row_directions.h"

#include <Eigen/QR>

#include "numerics/factors/jacobian_factor.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::MatrixXd;

RowSelection::RowSelection(int rows, int columns, int rank)
    : rank_(rank), J_(MatrixXd::Zero(rows, columns)) {
  order_.reserve(static_cast<std::size_t>(rows));
  for (Index i = 0; i < rank_; ++i) order_.push_back(i);
}

RowDirections RowSelection::frame() const {
  return {.t = 0.0,
          .directions = MatrixXd::Zero(J_.cols(), rank_),
          .sizes = Eigen::VectorXd::Zero(rank_)};
}

void RowSelection::measure(const TimedJacobian& jacobian, double t,
                           RowDirections& frame) {
  jacobian(t, J_);
  frame.t = t;
  for (Index i = 0; i < rank_; ++i) {
    auto r = frame.directions.col(i);
    r = J_.row(order_[static_cast<std::size_t>(i)]).transpose();
    const double length = r.norm();
    for (Index j = 0; j < i; ++j) {
      const auto q = frame.directions.col(j);
      r -= q.dot(r) * q;
    }
    const double left = r.norm();
    frame.sizes[i] = length > 0.0 ? left / length : 0.0;
    if (left > 0.0) r /= left;
  }
}

void RowSelection::choose(const TimedJacobian& jacobian, double t) {
  if (!has_others()) return;
  jacobian(t, J_);
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(J_.transpose());
  for (Index i = 0; i < rank_; ++i) {
    order_[static_cast<std::size_t>(i)] = qr.colsPermutation().indices()[i];
  }
}

double RowSelection::best_size(const TimedJacobian& jacobian, double t) {
  jacobian(t, J_);
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(J_.transpose());
  double best = 1.0;
  for (Index i = 0; i < rank_; ++i) {
    const Index row = qr.colsPermutation().indices()[i];
    best = std::min(best, std::abs(qr.matrixQR()(i, i)) / J_.row(row).norm());
  }
  return best;
}

bool RowSelection::loses_rank(const TimedJacobian& jacobian, double t) {
  jacobian(t, J_);
  return numerics::numerical_rank(J_) < rank_;
}

}  // namespace clevis::mechanism
