#include "mechanism/constrained_mass.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mechanism/jacobian_factor.h"

namespace clevis::mechanism {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

// Pivots of W Wᵀ are squares of those of W. Above the first bound Cholesky
// keeps nine digits of the multipliers; below the second a row depends on the
// others; in between the orthogonal decomposition judges.
constexpr double kSafePivot = 1e-7;
constexpr double kDependentPivot = 0.01 * kRankThreshold * kRankThreshold;
constexpr double kReturnFactor = 2.0;

}  // namespace

ConstrainedMass::ConstrainedMass(int columns, int most_rows)
    : columns_(columns),
      factors_(static_cast<std::size_t>(columns / 3)),
      order_(static_cast<std::size_t>(most_rows)),
      Wt_(MatrixXd::Zero(columns, most_rows)),
      S_(MatrixXd::Zero(most_rows, most_rows)),
      L_(MatrixXd::Zero(most_rows, most_rows)),
      scale_(VectorXd::Ones(most_rows)),
      x_(VectorXd::Zero(most_rows)),
      hat_rows_(VectorXd::Zero(most_rows)),
      hat_(VectorXd::Zero(columns)),
      decomposition_(std::max(most_rows, 1), std::max(columns, 1)) {
  std::iota(order_.begin(), order_.end(), 0);
}

void ConstrainedMass::apply_factor(VectorXd& v) const {
  for (std::size_t k = 0; k < factors_.size(); ++k) {
    auto part = v.segment<3>(static_cast<Eigen::Index>(3 * k));
    const Vector3d given = part;
    part = factors_[k].diagonal
               ? Vector3d(factors_[k].F.diagonal().cwiseProduct(given))
               : Vector3d(factors_[k].F * given);
  }
}

void ConstrainedMass::apply_factor_transposed(VectorXd& v) const {
  for (std::size_t k = 0; k < factors_.size(); ++k) {
    auto part = v.segment<3>(static_cast<Eigen::Index>(3 * k));
    const Vector3d given = part;
    part = factors_[k].diagonal
               ? Vector3d(factors_[k].F.diagonal().cwiseProduct(given))
               : Vector3d(factors_[k].F.transpose() * given);
  }
}

void ConstrainedMass::factor(const MatrixXd& J, int rows) {
  if (rows != rows_) {
    rows_ = rows;
    std::iota(order_.begin(), order_.end(), 0);
    reduced_ = false;
  }
  for (int i = 0; i < rows_; ++i) {
    auto w = Wt_.col(i);
    for (std::size_t k = 0; k < factors_.size(); ++k) {
      const auto at = static_cast<Eigen::Index>(3 * k);
      const Vector3d lever = J.row(i).segment<3>(at);
      w.segment<3>(at) =
          factors_[k].diagonal
              ? Vector3d(factors_[k].F.diagonal().cwiseProduct(lever))
              : Vector3d(factors_[k].F.transpose() * lever);
    }
    const double length = w.norm();
    scale_[i] = length > 0.0 ? 1.0 / length : 1.0;
    w *= scale_[i];
  }
  for (int i = 0; i < rows_; ++i) {
    for (int j = i; j < rows_; ++j) S_(j, i) = Wt_.col(i).dot(Wt_.col(j));
  }
  truncated_ = false;
  was_reduced_ = reduced_;
  if (!reduced_ && cholesky_in_order()) return;
  if (!pivoted_cholesky()) orthogonal(J.topRows(rows_));
}

/// Rows in the order of the last pivoting, as long as all pivots are safe.
bool ConstrainedMass::cholesky_in_order() {
  smallest_pivot_ = 1.0;
  for (int i = 0; i < rows_; ++i) {
    const int row = order_[static_cast<std::size_t>(i)];
    for (int j = 0; j < i; ++j) {
      const int other = order_[static_cast<std::size_t>(j)];
      double sum = S_(std::max(row, other), std::min(row, other));
      for (int k = 0; k < j; ++k) sum -= L_(k, i) * L_(k, j);
      L_(j, i) = sum * L_(j, j);
    }
    const double pivot = S_(row, row) - L_.col(i).head(i).squaredNorm();
    if (!(pivot > kSafePivot)) return false;
    smallest_pivot_ = std::min(smallest_pivot_, pivot);
    L_(i, i) = 1.0 / std::sqrt(pivot);  // its inverse: no division later
  }
  rank_ = rows_;
  return true;
}

/// Largest pivots first. @return false if a pivot is neither safe nor zero.
bool ConstrainedMass::pivoted_cholesky() {
  std::iota(order_.begin(), order_.end(), 0);
  VectorXd& left = x_;  // diagonal that is left
  for (int i = 0; i < rows_; ++i) left[i] = S_(i, i);
  smallest_pivot_ = 1.0;
  for (rank_ = 0; rank_ < rows_; ++rank_) {
    int best = rank_;
    for (int i = rank_ + 1; i < rows_; ++i) {
      if (left[order_[static_cast<std::size_t>(i)]] >
          left[order_[static_cast<std::size_t>(best)]]) {
        best = i;
      }
    }
    std::swap(order_[static_cast<std::size_t>(rank_)],
              order_[static_cast<std::size_t>(best)]);
    L_.col(rank_).swap(L_.col(best));  // what is known of both rows
    const int row = order_[static_cast<std::size_t>(rank_)];
    const double pivot = left[row];
    if (!(pivot > kSafePivot)) {
      reduced_ = true;
      return rank_ == geometric_rank_ && !(pivot > kDependentPivot);
    }
    smallest_pivot_ = std::min(smallest_pivot_, pivot);
    L_(rank_, rank_) = 1.0 / std::sqrt(pivot);
    for (int i = rank_ + 1; i < rows_; ++i) {
      const int other = order_[static_cast<std::size_t>(i)];
      double sum = S_(std::max(row, other), std::min(row, other));
      for (int k = 0; k < rank_; ++k) sum -= L_(k, rank_) * L_(k, i);
      L_(rank_, i) = sum * L_(rank_, rank_);
      left[other] -= L_(rank_, i) * L_(rank_, i);
    }
  }
  reduced_ = false;
  return true;
}

void ConstrainedMass::orthogonal(const MatrixXd& J) {
  ++orthogonal_count_;
  truncated_ = true;
  decomposition_.setThreshold(was_reduced_ ? kReturnFactor * kRankThreshold
                                           : kRankThreshold);
  decomposition_.compute(J);
  rank_ = geometric_rank_ = static_cast<int>(decomposition_.rank());
  reduced_ = rank_ < rows_;
  const MatrixXd Z = decomposition_.matrixZ();
  null_space_ = decomposition_.colsPermutation() *
                Z.bottomRows(columns_ - rank_).transpose();
  null_mass_.compute(null_space_.transpose() * mass_times(null_space_));
  const auto& R = decomposition_.matrixQTZ();
  const double ratio =
      rank_ > 0 ? std::abs(R(rank_ - 1, rank_ - 1) / R(0, 0)) : 1.0;
  smallest_pivot_ = ratio * ratio;
}

MatrixXd ConstrainedMass::mass_times(const MatrixXd& v) const {
  MatrixXd result(v.rows(), v.cols());
  for (std::size_t k = 0; k < factors_.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(3 * k);
    const Matrix3d& root = factors_[k].inverse;  // M = F⁻ᵀ F⁻¹
    result.middleRows<3>(at) = root.transpose() * (root * v.middleRows<3>(at));
  }
  return result;
}

VectorXd ConstrainedMass::completed(const VectorXd& v,
                                    const VectorXd& forces) const {
  const VectorXd unbalanced = forces - VectorXd(mass_times(v));
  return v +
         null_space_ * null_mass_.solve(null_space_.transpose() * unbalanced);
}

void ConstrainedMass::solve_normal() {
  for (int i = 0; i < rank_; ++i) {
    double sum = hat_rows_[order_[static_cast<std::size_t>(i)]];
    for (int k = 0; k < i; ++k) sum -= L_(k, i) * x_[k];
    x_[i] = sum * L_(i, i);
  }
  for (int i = rank_ - 1; i >= 0; --i) {
    double sum = x_[i];
    for (int k = i + 1; k < rank_; ++k) sum -= L_(i, k) * x_[k];
    x_[i] = sum * L_(i, i);
  }
}

void ConstrainedMass::accelerate(const VectorXd& gamma, const VectorXd& Q,
                                 VectorXd& a, VectorXd& lambda) {
  lambda.setZero();
  if (truncated_) {
    a = completed(decomposition_.solve(gamma.head(rows_)), Q);
    lambda.head(rows_) =
        decomposition_.transpose().solve(VectorXd(mass_times(a)) - Q);
    return;
  }
  hat_ = Q;
  apply_factor_transposed(hat_);
  for (int i = 0; i < rows_; ++i) {
    hat_rows_[i] = scale_[i] * gamma[i] - Wt_.col(i).dot(hat_);
  }
  solve_normal();
  for (int i = 0; i < rank_; ++i) {
    const int row = order_[static_cast<std::size_t>(i)];
    hat_ += x_[i] * Wt_.col(row);
    lambda[row] = scale_[row] * x_[i];
  }
  a = hat_;
  apply_factor(a);
}

void ConstrainedMass::correct(const VectorXd& residual, VectorXd& change) {
  if (truncated_) {
    change = completed(decomposition_.solve(-residual.head(rows_)),
                       VectorXd::Zero(columns_));
    return;
  }
  for (int i = 0; i < rows_; ++i) hat_rows_[i] = -scale_[i] * residual[i];
  solve_normal();
  change.setZero();
  for (int i = 0; i < rank_; ++i) {
    change += x_[i] * Wt_.col(order_[static_cast<std::size_t>(i)]);
  }
  apply_factor(change);
}

}  // namespace clevis::mechanism
