#include "dynamics/load_vibration/load_path.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace clevis::dynamics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Between secants a (over h_a) and b: their weighted harmonic mean, 0 at a
/// turn.
double inner_slope(double a, double h_a, double b, double h_b) {
  if (!(a * b > 0.0)) return 0.0;
  const double w_a = 2.0 * h_b + h_a, w_b = h_b + 2.0 * h_a;
  return (w_a + w_b) / (w_a / a + w_b / b);
}

/// At the end of a piece, a the secant there: of the parabola through three
/// points, kept so that the cubic stays between its ends.
double outer_slope(double a, double h_a, double b, double h_b) {
  const double slope = ((2.0 * h_a + h_b) * a - h_a * b) / (h_a + h_b);
  if (!(slope * a > 0.0)) return 0.0;
  return a * b <= 0.0 && std::abs(slope) > 3.0 * std::abs(a) ? 3.0 * a : slope;
}

}  // namespace

LoadPath::LoadPath(VectorXd time, MatrixXd values, double jump, Between between,
                   const std::vector<double>& bends)
    : time_(std::move(time)),
      values_(std::move(values)),
      jump_(jump),
      between_(between) {
  is_bend_.resize(static_cast<std::size_t>(size()));
  for (Index i = 0; i < size(); ++i) {
    const auto near = std::ranges::lower_bound(bends, time_[i] - jump);
    is_bend_[static_cast<std::size_t>(i)] =
        near != bends.end() && *near <= time_[i] + jump;
  }
  const Index intervals = std::max<Index>(0, size() - 1);
  start_ = end_ = MatrixXd::Zero(coordinates(), intervals);
  Index first = 0;
  for (Index i = 0; i <= intervals; ++i) {
    if (i < intervals && !is_jump(i)) continue;
    if (i > first) set_piece(first, i);
    first = i + 1;
  }
}

bool LoadPath::is_jump(Index i) const {
  return time_[i + 1] - time_[i] <= jump_;
}

VectorXd LoadPath::bend(Index i) const {
  if (is_jump(i)) {
    VectorXd step = VectorXd::Zero(coordinates());
    if (i > 0) step -= end_.col(i - 1);
    if (i + 2 < size()) step += start_.col(i + 1);
    return step;
  }
  if (i == 0) return start_.col(0);
  if (is_jump(i - 1)) return VectorXd::Zero(coordinates());
  return start_.col(i) - end_.col(i - 1);
}

/// Between the instants `first` and `last`, between which nothing jumps.
void LoadPath::set_piece(Index first, Index last) {
  constexpr double kBend = 4.0;
  for (Index k = 0; k < coordinates(); ++k) {
    const auto curvature = [&](Index i) {
      const double before = time_[i] - time_[i - 1];
      const double after = time_[i + 1] - time_[i];
      return std::abs((values_(k, i + 1) - values_(k, i)) / after -
                      (values_(k, i) - values_(k, i - 1)) / before) /
             (before + after);
    };
    Index begin = first;
    for (Index i = first + 1; i < last; ++i) {
      const auto beside = [&] {
        return std::max(i - 1 > begin ? curvature(i - 1) : 0.0,
                        i + 1 < last ? curvature(i + 1) : 0.0);
      };
      const bool is_inside = i >= first + 2 && i + 2 <= last;
      if (!is_bend(i) && !(is_inside && curvature(i) > kBend * beside())) {
        continue;
      }
      set_slopes(k, begin, i);
      begin = i;
    }
    set_slopes(k, begin, last);
  }
}

void LoadPath::set_slopes(Index k, Index first, Index last) {
  const auto width = [&](Index i) {
    return time_[i + 1] - time_[i];
  };
  const auto secant = [&](Index i) {
    return (values_(k, i + 1) - values_(k, i)) / width(i);
  };
  if (last - first == 1 || between_ == Between::kLinear) {
    for (Index i = first; i < last; ++i) {
      start_(k, i) = end_(k, i) = secant(i);
    }
    return;
  }
  start_(k, first) = outer_slope(secant(first), width(first), secant(first + 1),
                                 width(first + 1));
  for (Index i = first; i + 1 < last; ++i) {
    end_(k, i) = start_(k, i + 1) =
        inner_slope(secant(i), width(i), secant(i + 1), width(i + 1));
  }
  end_(k, last - 1) = outer_slope(secant(last - 1), width(last - 1),
                                  secant(last - 2), width(last - 2));
}

MatrixXd LoadPath::cubic(Index i) const {
  MatrixXd a = MatrixXd::Zero(coordinates(), 3);
  if (is_jump(i)) return a;
  const double h = time_[i + 1] - time_[i];
  const VectorXd secant = (values_.col(i + 1) - values_.col(i)) / h;
  a.col(0) = start_.col(i);
  a.col(1) = (3.0 * secant - 2.0 * start_.col(i) - end_.col(i)) / h;
  a.col(2) = (start_.col(i) + end_.col(i) - 2.0 * secant) / (h * h);
  return a;
}

VectorXd LoadPath::at(double t) const {
  const Index after = std::ranges::upper_bound(time_, t) - time_.begin();
  if (after == 0) return values_.col(0);
  const Index i = after - 1;
  if (after == size() || is_jump(i)) return values_.col(i);
  const MatrixXd a = cubic(i);
  const double since = t - time_[i];
  return values_.col(i) +
         since * (a.col(0) + since * (a.col(1) + since * a.col(2)));
}

LoadPath thinned(const LoadPath& path) {
  // Of fewer the half tells nothing of what lies between them.
  constexpr Index kFew = 6;  // intervals
  if (path.between() == LoadPath::Between::kLinear) return path;
  std::vector<Index> kept;
  std::vector<double> bends;
  double smallest = 0.0;
  Index first = 0;
  for (Index last = 0; last < path.size(); ++last) {
    const bool jumps = last + 1 == path.size() || path.is_jump(last);
    if (path.is_bend(last)) bends.push_back(path.time()[last]);
    if (!jumps && !path.is_bend(last)) continue;
    for (Index i = first; i <= last; ++i) {
      const bool is_few = last - first < kFew;
      const bool is_kept = is_few || i == last || (i - first) % 2 == 0;
      if (is_kept && (kept.empty() || kept.back() < i)) kept.push_back(i);
    }
    first = jumps ? last + 1 : last;
    if (jumps && first < path.size()) {
      smallest = std::max(smallest, path.time()[first] - path.time()[last]);
    }
  }
  const auto n = static_cast<Index>(kept.size());
  VectorXd time(n);
  MatrixXd values(path.coordinates(), n);
  for (Index i = 0; i < n; ++i) {
    time[i] = path.time()[kept[static_cast<std::size_t>(i)]];
    values.col(i) = path.values().col(kept[static_cast<std::size_t>(i)]);
  }
  return {std::move(time), std::move(values), smallest, path.between(), bends};
}

}  // namespace clevis::dynamics
