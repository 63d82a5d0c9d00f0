#include "numerics/factors/small_lu.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace clevis::numerics {

using Eigen::Index;
using Eigen::VectorXd;

void SmallLu::compute(const Eigen::MatrixXd& A) {
  const Index n = A.rows();
  lu_ = A;
  rows_.resize(static_cast<std::size_t>(n));
  std::iota(rows_.begin(), rows_.end(), Index{0});
  sign_ = 1;
  smallest_ = largest_ = n > 0 ? lu_.col(0).cwiseAbs().maxCoeff() : 0.0;
  for (Index k = 0; k < n; ++k) {
    Index best = k;
    double size = std::abs(lu_(k, k));
    for (Index i = k + 1; i < n; ++i) {
      if (std::abs(lu_(i, k)) > size) size = std::abs(lu_(i, k)), best = i;
    }
    smallest_ = std::min(smallest_, size);
    largest_ = std::max(largest_, size);
    if (best != k) {
      lu_.row(k).swap(lu_.row(best));
      std::swap(rows_[static_cast<std::size_t>(k)],
                rows_[static_cast<std::size_t>(best)]);
      sign_ = -sign_;
    }
    const double pivot = lu_(k, k);
    sign_ = pivot > 0.0 ? sign_ : pivot < 0.0 ? -sign_ : 0;
    if (!(size > 0.0)) return;
    const Index left = n - k - 1;
    auto below = lu_.col(k).tail(left);
    below *= 1.0 / pivot;
    for (Index j = k + 1; j < n; ++j) {
      const double factor = lu_(k, j);
      // Jacobians are sparse
      if (factor != 0.0) lu_.col(j).tail(left) -= factor * below;
    }
  }
}

VectorXd SmallLu::solve(const VectorXd& b) const {
  const Index n = b.size();
  VectorXd x(n);
  for (Index k = 0; k < n; ++k) x[k] = b[rows_[static_cast<std::size_t>(k)]];
  for (Index k = 0; k < n; ++k) {
    const Index left = n - k - 1;
    if (x[k] != 0.0) x.tail(left) -= x[k] * lu_.col(k).tail(left);
  }
  for (Index k = n; k-- > 0;) {
    x[k] /= lu_(k, k);
    if (x[k] != 0.0) x.head(k) -= x[k] * lu_.col(k).head(k);
  }
  return x;
}

VectorXd SmallLu::solve_transposed(const VectorXd& f) const {
  const Index n = f.size();
  VectorXd y = f, x(n);
  for (Index k = 0; k < n; ++k) {
    y[k] = (y[k] - lu_.col(k).head(k).dot(y.head(k))) / lu_(k, k);
  }
  for (Index k = n; k-- > 0;) {
    const Index left = n - k - 1;
    y[k] -= lu_.col(k).tail(left).dot(y.tail(left));
    x[rows_[static_cast<std::size_t>(k)]] = y[k];
  }
  return x;
}

}  // namespace clevis::numerics
