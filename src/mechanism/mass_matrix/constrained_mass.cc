#include "mechanism/mass_matrix/constrained_mass.h"

#include <algorithm>
#include <cmath>

#include "numerics/factors/jacobian_factor.h"

namespace clevis::mechanism {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

// Below it the second solution, of what the first leaves, wins back the digits
// that the squares lose.
constexpr double kRefinedPivot = 1e-2;
// Of the rank threshold, on the way back.
constexpr double kReturnFactor = 2.0;

}  // namespace

ConstrainedMass::ConstrainedMass(int columns, int most_rows, double threshold)
    : threshold_(threshold),
      columns_(columns),
      factors_(static_cast<std::size_t>(columns / 3)),
      normal_(columns, most_rows),
      scale_(VectorXd::Ones(most_rows)),
      x_(VectorXd::Zero(most_rows)),
      hat_rows_(VectorXd::Zero(most_rows)),
      hat_(VectorXd::Zero(columns)),
      decomposition_(std::max(most_rows, 1), std::max(columns, 1)) {}

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
  on_tree_ = false;
  if (rows != rows_) {
    rows_ = rows;
    normal_.reset(rows);
    reduced_ = false;
  }
  fill_rows(J);
  truncated_ = false;
  was_reduced_ = reduced_;
  const bool done =
      normal_.factor_in_order(reduced_ ? geometric_rank_ : rows_) ||
      normal_.factor_by_pivots(geometric_rank_);
  if (!done) {
    orthogonal(J.topRows(rows_));
    return;
  }
  rank_ = normal_.rank();
  reduced_ = rank_ < rows_;
  smallest_pivot_ = normal_.smallest_pivot();
}

void ConstrainedMass::set_tree(std::vector<TreeLink> links, int width) {
  if (links.empty()) return;
  tree_.emplace(std::move(links), width);
  width_ = width;
}

bool ConstrainedMass::factor_tree() {
  on_tree_ = tree_->factor();
  if (!on_tree_) return false;
  truncated_ = reduced_ = false;
  rows_ = -1;  // other ways start anew
  rank_ = tree_->rows();
  smallest_pivot_ = tree_->smallest_pivot();
  return true;
}

void ConstrainedMass::apply_factor_of_body(int body, double* part) const {
  for (int at = width_ * body; at < width_ * (body + 1); at += 3, part += 3) {
    const Factor& factor = factors_[static_cast<std::size_t>(at / 3)];
    const Matrix3d& F = factor.F;
    const double x = part[0], y = part[1], z = part[2];
    if (factor.diagonal) {
      part[0] = F(0, 0) * x;
      part[1] = F(1, 1) * y;
      part[2] = F(2, 2) * z;
      continue;
    }
    for (int k = 0; k < 3; ++k) {
      part[k] = F(0, k) * x + F(1, k) * y + F(2, k) * z;
    }
  }
}

void ConstrainedMass::solve_tree(const VectorXd& gamma, VectorXd& a,
                                 VectorXd& lambda) {
  apply_factor_transposed(a);
  tree_->solve(gamma, a, lambda);
  if (smallest_pivot_ < kRefinedPivot) tree_->refine(gamma, a, lambda);
  apply_factor(a);
}

/// W = J F.
void ConstrainedMass::fill_rows(const MatrixXd& J) {
  for (int i = 0; i < rows_; ++i) {
    hat_ = J.row(i);
    apply_factor_transposed(hat_);
    scale_[i] = 1.0 / normal_.set_row(i, hat_);
  }
}

void ConstrainedMass::orthogonal(const MatrixXd& J) {
  ++orthogonal_count_;
  truncated_ = true;
  decomposition_.setThreshold(was_reduced_ ? kReturnFactor * threshold_
                                           : threshold_);
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

void ConstrainedMass::accelerate(const VectorXd& gamma, const VectorXd& Q,
                                 VectorXd& a, VectorXd& lambda) {
  lambda.setZero();
  if (on_tree_) {
    a = Q;
    solve_tree(gamma, a, lambda);
    return;
  }
  if (truncated_) {
    a = completed(decomposition_.solve(gamma.head(rows_)), Q);
    lambda.head(rows_) =
        decomposition_.transpose().solve(VectorXd(mass_times(a)) - Q);
    return;
  }
  hat_ = Q;
  apply_factor_transposed(hat_);
  for (int i = 0; i < rows_; ++i) {
    hat_rows_[i] = scale_[i] * gamma[i] - normal_.row_times(i, hat_);
  }
  normal_.solve(hat_rows_, x_);
  for (int i = 0; i < rows_; ++i) {
    normal_.add_row(i, x_[i], hat_);
    lambda[i] = scale_[i] * x_[i];
  }
  if (smallest_pivot_ < kRefinedPivot) {
    for (int i = 0; i < rows_; ++i) {
      hat_rows_[i] = scale_[i] * gamma[i] - normal_.row_times(i, hat_);
    }
    normal_.solve(hat_rows_, x_);
    for (int i = 0; i < rows_; ++i) {
      normal_.add_row(i, x_[i], hat_);
      lambda[i] += scale_[i] * x_[i];
    }
  }
  a = hat_;
  apply_factor(a);
}

void ConstrainedMass::correct(const VectorXd& residual, VectorXd& change) {
  if (on_tree_) {
    hat_rows_ = -residual;
    change.setZero();
    solve_tree(hat_rows_, change, x_);
    return;
  }
  if (truncated_) {
    change = completed(decomposition_.solve(-residual.head(rows_)),
                       VectorXd::Zero(columns_));
    return;
  }
  for (int i = 0; i < rows_; ++i) hat_rows_[i] = -scale_[i] * residual[i];
  normal_.solve(hat_rows_, x_);
  change.setZero();
  for (int i = 0; i < rows_; ++i) normal_.add_row(i, x_[i], change);
  apply_factor(change);
}

}  // namespace clevis::mechanism
