#include "numerics/factors/jacobian_factor.h"

#include "base/algebra/singular_vectors.h"

namespace clevis::numerics {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// LU serves down to this part of the Frobenius norm for the smallest singular
// value; the rank is judged below it.
constexpr double kSafeCondition = 1e-3;
// Of pivots over the largest: an exactly singular LU solves nothing.
constexpr double kNoPivot = 1e-12;

}  // namespace

void JacobianFactor::compute(const MatrixXd& J, const JacobianFactor* near,
                             double threshold) {
  rows_ = static_cast<int>(J.rows());
  columns_ = static_cast<int>(J.cols());
  determinant_sign_ = 0;
  regular_ = false;
  if (J.rows() == J.cols() && J.cols() > 0) {
    lu_.compute(J);
    determinant_sign_ = lu_.determinant_sign();
    rank_ = columns_;
    regular_ = lu_.smallest_pivot() > kNoPivot * lu_.largest_pivot();
    if (regular_) {
      weakest_ = find_weakest(near);
      regular_ = weakest_.sigma > kSafeCondition * J.norm();
    }
    if (regular_) return;
  }
  orthogonal_.setThreshold(threshold);
  orthogonal_.compute(J);
  rank_ = static_cast<int>(orthogonal_.rank());
  if (rank_ < columns_) determinant_sign_ = 0;
}

VectorXd JacobianFactor::solve(const VectorXd& b) const {
  if (regular_) return lu_.solve(b);
  return orthogonal_.solve(b);
}

VectorXd JacobianFactor::solve_transposed(const VectorXd& f) const {
  if (regular_) return lu_.solve_transposed(f);
  return orthogonal_.transpose().solve(f);
}

/// Inverse iteration, from the vector nearby or one without symmetry. A part of
/// the latter is always there: another value may have become the smallest.
JacobianFactor::Weakest JacobianFactor::find_weakest(
    const JacobianFactor* near) const {
  constexpr double kPart = 0.1;
  Weakest w;
  w.v = VectorXd::LinSpaced(columns_, 1.0, 2.0).normalized();
  const bool is_known =
      near != nullptr && near->regular_ && near->columns_ == columns_;
  if (is_known) w.v = kPart * w.v + near->weakest_.v;
  for (int i = 0; i < (is_known ? 1 : 3); ++i) {
    w.v.normalize();
    w.u = solve_transposed(w.v);
    w.u.normalize();
    w.v = solve(w.u);
  }
  w.sigma = 1.0 / w.v.norm();
  w.v *= w.sigma;
  return w;
}

JacobianFactor::Weakest JacobianFactor::weakest() const {
  return regular_ ? weakest_ : find_weakest(nullptr);
}

MatrixXd JacobianFactor::left_null_space() const {
  const int open = rows_ - rank_;
  MatrixXd N = MatrixXd::Zero(rows_, open);
  N.bottomRows(open).setIdentity();
  if (open > 0) N.applyOnTheLeft(orthogonal_.householderQ());
  return N;
}

RowDependence row_dependence(const MatrixXd& J) {
  RowDependence result;
  const auto rows = static_cast<std::size_t>(J.rows());
  result.dependent.assign(rows, false);
  if (J.size() == 0) return result;
  const MatrixXd left_null = clevis::null_space(J.transpose(), kRankThreshold);
  result.rank = static_cast<int>(J.rows() - left_null.cols());
  for (std::size_t i = 0; i < rows; ++i) {
    // entries of a vector of a row that is not involved are round-off
    result.dependent[i] =
        left_null.row(static_cast<Eigen::Index>(i)).norm() > 1e-7;
  }
  return result;
}

MatrixXd null_space(const MatrixXd& J) {
  return clevis::null_space(J, kRankThreshold);
}

int numerical_rank(const MatrixXd& J) {
  const VectorXd sigma = singular_values(J);
  if (sigma.size() == 0) return 0;
  return static_cast<int>((sigma.array() > kRankThreshold * sigma[0]).count());
}

}  // namespace clevis::numerics
