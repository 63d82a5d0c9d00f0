#include "numerics/factors/normal_cholesky.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/values/index.h"
#include "numerics/factors/jacobian_factor.h"

namespace clevis::numerics {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

// Pivots of W Wᵀ are squares of those of W. Above the first bound Cholesky
// keeps nine digits of the multipliers; below the second a row depends on the
// others; what is in between it does not judge.
constexpr double kSafePivot = 1e-8;
constexpr double kDependentPivot = 0.01 * kRankThreshold * kRankThreshold;

/// Four sums, so that one product need not wait for the last.
double dot(const double* a, const double* b, int n) {
  double s0 = 0.0, s1 = 0.0, s2 = 0.0, s3 = 0.0;
  int k = 0;
  for (; k + 4 <= n; k += 4) {
    s0 += a[k] * b[k];
    s1 += a[k + 1] * b[k + 1];
    s2 += a[k + 2] * b[k + 2];
    s3 += a[k + 3] * b[k + 3];
  }
  for (; k < n; ++k) s0 += a[k] * b[k];
  return (s0 + s1) + (s2 + s3);
}

}  // namespace

NormalCholesky::NormalCholesky(int columns, int most_rows)
    : order_(index(most_rows)),
      first_(index(most_rows)),
      first_at_(index(columns / 3)),
      blocks_(index(most_rows)),
      Wt_(Eigen::MatrixXd::Zero(columns, most_rows)),
      L_(Eigen::MatrixXd::Zero(most_rows, most_rows)),
      left_(VectorXd::Zero(most_rows)),
      x_(VectorXd::Zero(most_rows)) {
  for (std::vector<int>& blocks : blocks_) blocks.reserve(first_at_.size());
}

void NormalCholesky::reset(int rows) {
  rows_ = rows;
  std::iota(order_.begin(), order_.end(), 0);
  may_sort_ = is_sorted_ = true;
  sort_next_ = false;
}

double NormalCholesky::set_row(int i, const VectorXd& w) {
  std::vector<int>& blocks = blocks_[index(i)];
  blocks.clear();
  double square = 0.0;
  for (Index at = 0; at < w.size(); at += 3) {
    const double part = w.segment<3>(at).squaredNorm();
    if (part > 0.0) blocks.push_back(static_cast<int>(at));
    square += part;
  }
  const double length = square > 0.0 ? std::sqrt(square) : 1.0;
  Wt_.col(i) = (1.0 / length) * w;
  return length;
}

double NormalCholesky::row_times(int i, const VectorXd& v) const {
  double sum = 0.0;
  for (const int at : blocks_[index(i)]) {
    sum += Wt_.col(i).segment<3>(at).dot(v.segment<3>(at));
  }
  return sum;
}

void NormalCholesky::add_row(int i, double factor, VectorXd& v) const {
  for (const int at : blocks_[index(i)]) {
    v.segment<3>(at) += factor * Wt_.col(i).segment<3>(at);
  }
}

/// Those that count first, each group as it came.
void NormalCholesky::order_by_rows() {
  std::sort(order_.begin(), order_.begin() + rank_);
  std::sort(order_.begin() + rank_, order_.begin() + rows_);
  is_sorted_ = true;
  sort_next_ = false;
}

void NormalCholesky::place_skyline() {
  std::ranges::fill(first_at_, rows_);
  for (int i = 0; i < rows_; ++i) {
    int& first = first_[index(i)];
    first = i;
    for (const int at : blocks_[index(order_[index(i)])]) {
      int& touched = first_at_[index(at / 3)];
      touched = std::min(touched, i);
      first = std::min(first, touched);
    }
  }
}

/// Row i of L against the first `rank` ones. @return the pivot left.
double NormalCholesky::eliminate(int i, int rank) {
  const int row = order_[index(i)];
  const int first = first_[index(i)];
  double* l = L_.col(i).data();
  double pivot = Wt_.col(row).squaredNorm();
  for (int j = first; j < std::min(i, rank); ++j) {
    const int other = order_[index(j)];
    double sum = 0.0;
    for (const int at : blocks_[index(row)]) {
      sum += Wt_.col(row).segment<3>(at).dot(Wt_.col(other).segment<3>(at));
    }
    const int from = std::max(first, first_[index(j)]);
    sum -= dot(l + from, L_.col(j).data() + from, j - from);
    l[j] = sum * L_(j, j);
    pivot -= l[j] * l[j];
  }
  return pivot;
}

bool NormalCholesky::factor_in_order(int rank) {
  if (sort_next_) order_by_rows();
  place_skyline();
  smallest_pivot_ = 1.0;
  for (int i = 0; i < rows_; ++i) {
    const double pivot = eliminate(i, rank);
    if (i >= rank) {
      if (pivot > kDependentPivot) return false;
      continue;
    }
    if (!(pivot > kSafePivot)) return false;
    smallest_pivot_ = std::min(smallest_pivot_, pivot);
    L_(i, i) = 1.0 / std::sqrt(pivot);  // its inverse: no division later
  }
  rank_ = rank;
  return true;
}

bool NormalCholesky::factor_by_pivots(int rank) {
  if (is_sorted_ && rank_ < rows_) may_sort_ = false;
  std::iota(order_.begin(), order_.end(), 0);
  std::ranges::fill(first_, 0);
  left_.setOnes();
  L_.setZero();
  smallest_pivot_ = 1.0;
  is_sorted_ = false;
  for (rank_ = 0; rank_ < rows_; ++rank_) {
    int best = rank_;
    for (int i = rank_ + 1; i < rows_; ++i) {
      if (left_[order_[index(i)]] > left_[order_[index(best)]]) best = i;
    }
    std::swap(order_[index(rank_)], order_[index(best)]);
    L_.col(rank_).swap(L_.col(best));  // what is known of both rows
    const int row = order_[index(rank_)];
    const double pivot = left_[row];
    if (!(pivot > kSafePivot)) {
      const bool clear = rank_ == rank && !(pivot > kDependentPivot);
      sort_next_ = clear && may_sort_;
      return clear;
    }
    smallest_pivot_ = std::min(smallest_pivot_, pivot);
    L_(rank_, rank_) = 1.0 / std::sqrt(pivot);
    for (int i = rank_ + 1; i < rows_; ++i) {
      const int other = order_[index(i)];
      const double sum = row_times(other, Wt_.col(row)) -
                         dot(L_.col(rank_).data(), L_.col(i).data(), rank_);
      L_(rank_, i) = sum * L_(rank_, rank_);
      left_[other] -= L_(rank_, i) * L_(rank_, i);
    }
  }
  return true;
}

void NormalCholesky::solve(const VectorXd& rows, VectorXd& x) {
  for (int i = 0; i < rank_; ++i) {
    const int first = first_[index(i)];
    const double sum =
        rows[order_[index(i)]] -
        dot(L_.col(i).data() + first, x_.data() + first, i - first);
    x_[i] = sum * L_(i, i);
  }
  x.head(rows_).setZero();
  for (int i = rank_ - 1; i >= 0; --i) {
    const double value = x_[i] * L_(i, i);
    x[order_[index(i)]] = value;
    for (int k = first_[index(i)]; k < i; ++k) x_[k] -= value * L_(k, i);
  }
}

}  // namespace clevis::numerics
