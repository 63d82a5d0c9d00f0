#include "mechanism/normal_cholesky.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

#include "mechanism/jacobian_factor.h"

namespace clevis::mechanism {

using Eigen::VectorXd;

namespace {

// Pivots of W Wᵀ are squares of those of W. Above the first bound Cholesky
// keeps nine digits of the multipliers; below the second a row depends on the
// others; what is in between it does not judge.
constexpr double kSafePivot = 1e-8;
constexpr double kDependentPivot = 0.01 * kRankThreshold * kRankThreshold;
// Below it rows that are left out are chosen anew: as they were, by their
// order, they need not be the best. That pays where it is rarely done.
constexpr double kSafeChoice = 1e-6;
constexpr int kRarely = 20;

/// Four sums, so that one product need not wait for the last.
inline double dot(const double* a, const double* b, int n) {
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

using Part = NormalCholesky::Part;

template <int kWidth>
using Columns = Eigen::Matrix<double, kWidth, 1>;

template <int kWidth>
auto columns(const Part& part) {
  return Eigen::Map < const Columns<kWidth>,
         kWidth == 6 ? Eigen::Aligned16 : 0 > (part.w);
}

template <int kWidth>
inline double dot(const Part& a, const Part& b) {
  return columns<kWidth>(a).dot(columns<kWidth>(b));
}

inline double dot(const Part& a, const Part& b, int width) {
  return width == 6 ? dot<6>(a, b) : dot<3>(a, b);
}

}  // namespace

NormalCholesky::NormalCholesky(int width, int bodies, int most_rows)
    : width_(width),
      rows_of_(index(most_rows)),
      order_(index(most_rows)),
      first_(index(most_rows)),
      touches_(index(Row::kMostParts * most_rows)),
      bodies_(index(bodies)),
      L_(Eigen::MatrixXd::Zero(most_rows, most_rows)),
      left_(VectorXd::Zero(most_rows)),
      x_(VectorXd::Zero(most_rows)) {}

void NormalCholesky::reset(int rows) {
  rows_ = rows;
  std::iota(order_.begin(), order_.end(), 0);
  may_sort_ = true;
  is_sorted_ = sort_next_ = is_arranged_ = false;
}

void NormalCholesky::open_rows() {
  for (int i = 0; i < rows_; ++i) {
    Row& row = rows_of_[index(i)];
    row.last_count = std::exchange(row.count, 0);
  }
}

double* NormalCholesky::part(int i, int body) {
  Row& row = rows_of_[index(i)];
  for (Part& known : row) {
    if (known.body == body) return known.w;
  }
  assert(row.count < Row::kMostParts);
  Part& added = row.parts[row.count++];
  if (added.body != body) is_arranged_ = false;
  added.body = body;
  std::fill_n(added.w, 6, 0.0);
  return added.w;
}

double NormalCholesky::close_row(int i) {
  Row& row = rows_of_[index(i)];
  if (row.count != row.last_count) is_arranged_ = false;
  double square = 0.0;
  for (const Part& part : row) square += dot(part, part, width_);
  if (!(square > 0.0)) return 1.0;
  const double length = std::sqrt(square), scale = 1.0 / length;
  for (Part& part : row) {
    for (double& w : part.w) w *= scale;
  }
  return length;
}

template <int kWidth>
double NormalCholesky::row_times(int i, const double* v) const {
  double sum = 0.0;
  for (const Part& part : rows_of_[index(i)]) {
    sum += columns<kWidth>(part).dot(
        Eigen::Map<const Columns<kWidth>>(v + kWidth * part.body));
  }
  return sum;
}

template <int kWidth>
void NormalCholesky::add_row(int i, double factor, double* v) const {
  for (const Part& part : rows_of_[index(i)]) {
    Eigen::Map<Columns<kWidth>>(v + kWidth * part.body) +=
        factor * columns<kWidth>(part);
  }
}

void NormalCholesky::times(const VectorXd& v, VectorXd& rows) const {
  for (int i = 0; i < rows_; ++i) {
    rows[i] =
        width_ == 6 ? row_times<6>(i, v.data()) : row_times<3>(i, v.data());
  }
}

void NormalCholesky::add_rows(const VectorXd& factors, VectorXd& v) const {
  for (int i = 0; i < rows_; ++i) {
    width_ == 6 ? add_row<6>(i, factors[i], v.data())
                : add_row<3>(i, factors[i], v.data());
  }
}

/// wᵢ · wⱼ.
double NormalCholesky::product(int i, int j) const {
  double sum = 0.0;
  for (const Part& a : rows_of_[index(i)]) {
    for (const Part& b : rows_of_[index(j)]) {
      if (a.body == b.body) sum += dot(a, b, width_);
    }
  }
  return sum;
}

/// Those that count first, each group as it came.
void NormalCholesky::order_by_rows() {
  std::sort(order_.begin(), order_.begin() + rank_);
  std::sort(order_.begin() + rank_, order_.begin() + rows_);
  is_sorted_ = true;
  sort_next_ = is_arranged_ = false;
  served_ = 0;
}

/// Which rows meet at each body, and the skyline.
void NormalCholesky::arrange() {
  for (Body& body : bodies_) body.end = 0;
  for (int i = 0; i < rows_; ++i) {
    for (const Part& part : rows_of_[index(i)]) {
      ++bodies_[index(part.body)].end;
    }
  }
  int begin = 0;
  for (Body& body : bodies_) {
    body.begin = begin;
    begin += std::exchange(body.end, begin);
  }
  for (int i = 0; i < rows_; ++i) {
    const int row = order_[index(i)];
    int& first = first_[index(i)];
    first = i;
    for (int k = 0; k < rows_of_[index(row)].count; ++k) {
      Body& body = bodies_[index(rows_of_[index(row)].parts[k].body)];
      touches_[index(body.end++)] = {i, row, k};
      first = std::min(first, touches_[index(body.begin)].place);
    }
  }
  is_arranged_ = true;
}

/// W Wᵀ in the order, within the skyline.
template <int kWidth>
void NormalCholesky::multiply_rows() {
  for (int i = 0; i < rows_; ++i) {
    double* l = L_.col(i).data();
    std::fill(l + first_[index(i)], l + i + 1, 0.0);
  }
  const auto part = [this](int k) -> const Part& {
    const Touch& touch = touches_[index(k)];
    return rows_of_[index(touch.row)].parts[touch.part];
  };
  for (const Body& body : bodies_) {
    for (int k = body.begin; k < body.end; ++k) {
      const Part& of_k = part(k);
      double* l = L_.col(touches_[index(k)].place).data();
      for (int m = body.begin; m <= k; ++m) {
        l[touches_[index(m)].place] += dot<kWidth>(of_k, part(m));
      }
    }
  }
}

/// Row i of L against the first `rank` ones. @return the pivot left.
double NormalCholesky::eliminate(int i, int rank) {
  const int first = first_[index(i)], end = std::min(i, rank);
  const Eigen::Index stride = L_.rows();
  double* const l = L_.col(i).data();
  const double* of_j = L_.col(first).data();
  double pivot = l[i];
  for (int j = first; j < end; ++j, of_j += stride) {
    const int from = std::max(first, first_[index(j)]);
    l[j] = (l[j] - dot(l + from, of_j + from, j - from)) * of_j[j];
    pivot -= l[j] * l[j];
  }
  return pivot;
}

bool NormalCholesky::factor_in_order(int rank) {
  if (sort_next_ && rank == rank_) order_by_rows();
  if (!is_arranged_) arrange();
  width_ == 6 ? multiply_rows<6>() : multiply_rows<3>();
  smallest_pivot_ = 1.0;
  const double safe = is_sorted_ ? kSafeChoice : kSafePivot;
  for (int i = 0; i < rows_; ++i) {
    const double pivot = eliminate(i, rank);
    if (i >= rank) {
      if (pivot > kDependentPivot) return false;
      continue;
    }
    if (!(pivot > safe)) return false;
    smallest_pivot_ = std::min(smallest_pivot_, pivot);
    L_(i, i) = 1.0 / std::sqrt(pivot);  // its inverse: no division later
  }
  rank_ = rank;
  ++served_;
  return true;
}

bool NormalCholesky::factor_by_pivots(int rank) {
  if (is_sorted_) may_sort_ = served_ >= kRarely;
  std::iota(order_.begin(), order_.end(), 0);
  std::ranges::fill(first_, 0);
  for (int i = 0; i < rows_; ++i) left_[i] = product(i, i) > 0.0 ? 1.0 : 0.0;
  L_.setZero();
  smallest_pivot_ = 1.0;
  is_sorted_ = is_arranged_ = false;
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
      sort_next_ = may_sort_ && !(pivot > kDependentPivot);
      return rank_ == rank && !(pivot > kDependentPivot);
    }
    smallest_pivot_ = std::min(smallest_pivot_, pivot);
    L_(rank_, rank_) = 1.0 / std::sqrt(pivot);
    for (int i = rank_ + 1; i < rows_; ++i) {
      const int other = order_[index(i)];
      const double sum = product(other, row) -
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
    const double* l = L_.col(i).data();
    const double sum =
        rows[order_[index(i)]] - dot(l + first, x_.data() + first, i - first);
    x_[i] = sum * l[i];
  }
  x.head(rows_).setZero();
  for (int i = rank_ - 1; i >= 0; --i) {
    const double* l = L_.col(i).data();
    const double value = x_[i] * l[i];
    x[order_[index(i)]] = value;
    for (int k = first_[index(i)]; k < i; ++k) x_[k] -= value * l[k];
  }
}

}  // namespace clevis::mechanism
