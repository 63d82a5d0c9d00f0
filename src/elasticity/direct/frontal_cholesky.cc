#include "elasticity/direct/frontal_cholesky.h"

#include <algorithm>
#include <utility>

#include "base/messages/errors.h"
#include "elasticity/direct/elimination.h"

namespace clevis::elasticity {
namespace {

using Eigen::MatrixXd;

/// Row i holds the entries of the i-th eliminated unknown with itself and with
/// later ones; columns in no order.
UpperTriangle ordered(const MatrixRows& matrix, const std::vector<int>& place) {
  const auto n = static_cast<std::size_t>(matrix.rows());
  std::vector<int> next(n + 1, 0);
  const auto each = [&](const auto& visit) {
    MatrixRows::Room room;
    for (std::size_t i = 0; i < n; ++i) {
      const auto [columns, values] = matrix.row(static_cast<int>(i), room);
      for (std::size_t k = 0; k < columns.size(); ++k) {
        const int j = place[static_cast<std::size_t>(columns[k])];
        const auto [first, later] = std::minmax(place[i], j);
        visit(static_cast<std::size_t>(first), later, values[k]);
      }
    }
  };
  each([&](std::size_t first, int, double) {
    ++next[first + 1];
  });
  for (std::size_t i = 0; i < n; ++i) next[i + 1] += next[i];
  UpperTriangle result;
  result.row_start = next;
  result.column.resize(static_cast<std::size_t>(next.back()));
  result.value.resize(result.column.size());
  each([&](std::size_t first, int later, double value) {
    const auto to = static_cast<std::size_t>(next[first]++);
    result.column[to] = later;
    result.value[to] = value;
  });
  return result;
}

bool is_in_order(const std::vector<int>& place) {
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (place[i] != static_cast<int>(i)) return false;
  }
  return true;
}

}  // namespace

template <typename Real>
FrontalFactor<Real>::FrontalFactor(const MatrixRows& matrix, FrontTree tree,
                                   const std::string& name, int threads)
    : tree_(std::move(tree)),
      factor_(large_buffer<Real>(tree_.factor_entries())) {
  std::size_t next = 0;
  for (const Front& front : tree_.fronts) {
    start_.push_back(next);
    next += front.panel_entries();
  }
  const bool is_positive =
      is_in_order(tree_.place)
          ? eliminate_fronts<Real>(matrix, tree_, start_, threads,
                                   factor_.get())
          : eliminate_fronts<Real>(ordered(matrix, tree_.place), tree_, start_,
                                   threads, factor_.get());
  if (is_positive) return;
  throw Error("F002", name, "the stiffness matrix is not positive definite",
              "Check the mesh quality and the material.");
}

template <typename Real>
void FrontalFactor<Real>::forward_all(MatrixOf<Real>& x) const {
  MatrixOf<Real> border;
  for (std::size_t f = 0; f < tree_.fronts.size(); ++f) {
    const Front& front = tree_.fronts[f];
    forward<Real>(panel(f), x.middleRows(front.begin, front.own()), border);
    for (int k = 0; k < front.later(); ++k) {
      x.row(front.border[static_cast<std::size_t>(k)]) -= border.row(k);
    }
  }
}

template <typename Real>
void FrontalFactor<Real>::backward_all(MatrixOf<Real>& x) const {
  MatrixOf<Real> border;
  for (std::size_t f = tree_.fronts.size(); f-- > 0;) {
    const Front& front = tree_.fronts[f];
    border.resize(front.later(), x.cols());
    for (int k = 0; k < front.later(); ++k) {
      border.row(k) = x.row(front.border[static_cast<std::size_t>(k)]);
    }
    backward<Real>(panel(f), border, x.middleRows(front.begin, front.own()));
  }
}

template <typename Real>
MatrixXd FrontalFactor<Real>::solve(const MatrixXd& right_hand_sides) const {
  return solve_upper(solve_lower(right_hand_sides));
}

template <typename Real>
MatrixXd FrontalFactor<Real>::solve_lower(
    const MatrixXd& right_hand_sides) const {
  MatrixOf<Real> x(right_hand_sides.rows(), right_hand_sides.cols());
  for (Eigen::Index e = 0; e < x.rows(); ++e) {
    x.row(tree_.place[static_cast<std::size_t>(e)]) =
        right_hand_sides.row(e).template cast<Real>();
  }
  forward_all(x);
  return x.template cast<double>();
}

template <typename Real>
MatrixXd FrontalFactor<Real>::solve_upper(const MatrixXd& ordered) const {
  MatrixOf<Real> x = ordered.template cast<Real>();
  backward_all(x);
  MatrixXd result(x.rows(), x.cols());
  for (Eigen::Index e = 0; e < x.rows(); ++e) {
    result.row(e) =
        x.row(tree_.place[static_cast<std::size_t>(e)]).template cast<double>();
  }
  return result;
}

template class FrontalFactor<double>;
template class FrontalFactor<float>;

}  // namespace clevis::elasticity
