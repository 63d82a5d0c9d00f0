#include "mechanism/change_points/singular_position.h"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>

#include "base/algebra/singular_vectors.h"
#include "numerics/factors/jacobian_factor.h"

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Branches that meet at a smaller angle are not told apart; positions within
// kRankThreshold of the singular one blur them by as much.
constexpr double kSameBranch = 1e-3;
constexpr double kSameVelocity = 0.02;

MatrixXd open_directions(const MatrixXd& A, double threshold) {
  const SingularVectors found = singular_vectors(A);
  return found.left(found.count_above(threshold));
}

/// Coefficients that no velocity is special among: any fixed numbers.
VectorXd scattered(Index size, int seed) {
  VectorXd v(size);
  for (Index i = 0; i < size; ++i) {
    const auto place = static_cast<double>(i);
    const double phase = 0.7 + 1.3 * seed + 2.1 * place * seed;
    v[i] = (0.2 + 0.1 * (seed % 40)) * std::sin(phase * (1.0 + 0.37 * place));
  }
  return v;
}

}  // namespace

SingularPosition::SingularPosition(const ConstraintSystem& joints,
                                   const Configuration& x)
    : length_(joints.scale({JointRow::Kind::kRotation})) {
  const auto placed = joints.place(x);
  const MatrixXd J = joints.jacobian(placed);
  const SingularVectors found = singular_vectors(J);
  const Index rank = found.rank(numerics::kRankThreshold);
  velocities_ = found.left(rank);
  const MatrixXd dependent = found.left_rows(rank);
  const auto bias = [&](const VectorXd& v) {
    return VectorXd(length_ * dependent.transpose() *
                    joints.bias(placed, joints.twists(v)));
  };
  const Index d = velocities_.cols();
  forms_.assign(static_cast<std::size_t>(dependent.cols()),
                MatrixXd::Zero(d, d));
  for (Index j = 0; j < d; ++j) {
    const VectorXd own = bias(velocities_.col(j));
    for (Index k = 0; k <= j; ++k) {
      const VectorXd both = bias(velocities_.col(j) + velocities_.col(k)) -
                            own - bias(velocities_.col(k));
      for (std::size_t i = 0; i < forms_.size(); ++i) {
        forms_[i](j, k) = forms_[i](k, j) = 0.5 * both[static_cast<Index>(i)];
      }
    }
  }
}

VectorXd SingularPosition::second_order(const VectorXd& y) const {
  VectorXd values(static_cast<Index>(forms_.size()));
  for (std::size_t i = 0; i < forms_.size(); ++i) {
    values[static_cast<Index>(i)] = y.dot(forms_[i] * y);
  }
  return values;
}

/// Half the derivative of second_order().
MatrixXd SingularPosition::second_order_change(const VectorXd& y) const {
  MatrixXd rows(static_cast<Index>(forms_.size()), y.size());
  for (std::size_t i = 0; i < forms_.size(); ++i) {
    rows.row(static_cast<Index>(i)) = (forms_[i] * y).transpose();
  }
  return rows;
}

MatrixXd SingularPosition::tangents(const VectorXd& v) const {
  const VectorXd y = (velocities_.transpose() * v).normalized();
  return velocities_ * open_directions(second_order_change(y), kSameBranch);
}

std::vector<VectorXd> SingularPosition::velocities(
    const MatrixXd& rows, const VectorXd& rates) const {
  constexpr int kStarts = 120, kIterations = 60;
  const MatrixXd reduced = rows * velocities_;
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver;
  solver.setThreshold(1e-9);
  solver.compute(reduced);
  const VectorXd given = solver.solve(rates);
  const double size = given.norm();
  if ((reduced * given - rates).norm() > kSameBranch * rates.norm()) return {};
  // what the rates leave open
  const MatrixXd open = open_directions(reduced, 1e-9);
  std::vector<VectorXd> found;
  for (int start = 0; start < (open.cols() == 0 ? 1 : kStarts); ++start) {
    VectorXd y = given + size * (open * scattered(open.cols(), start));
    for (int i = 0; i < kIterations && open.cols() > 0; ++i) {
      const MatrixXd slope = 2.0 * second_order_change(y) * open;
      y -= open * VectorXd(slope.completeOrthogonalDecomposition().solve(
                      second_order(y)));
    }
    const double scale = std::max(size, y.norm());
    const double allowed = open.cols() == 0 ? kSameBranch : 1e-6;
    if (!(second_order(y).norm() <= allowed * scale * scale)) continue;
    const VectorXd v = velocities_ * y;
    const bool known = std::ranges::any_of(found, [&](const VectorXd& other) {
      return (v - other).norm() < kSameVelocity * std::max(size, v.norm());
    });
    if (!known) found.push_back(v);
  }
  return found;
}

namespace {

// Regular positions on each side, at multiples of a distance that is far
// beyond the rank threshold and small against the length.
constexpr int kNodes = 4;
constexpr double kApart = 0.005;
// of the value, and of the derivative times the distance, in the middle
constexpr double kMiddle[kNodes] = {0.8, -0.4, 4.0 / 35.0, -1.0 / 70.0};
constexpr double kSlope[kNodes] = {0.8, -0.2, 4.0 / 105.0, -1.0 / 280.0};

/// Closes the joints with steps across the tangents alone; gives the tangents
/// there, nothing if the position is not regular.
std::optional<MatrixXd> close_on_branch(const ConstraintSystem& joints,
                                        const MatrixXd& coordinates,
                                        Configuration& x) {
  constexpr int kIterations = 30;
  const double length = joints.scale({JointRow::Kind::kRotation});
  const Index m = coordinates.cols();
  MatrixXd A(joints.rows() + m, joints.columns());
  A.bottomRows(m) = coordinates.transpose();
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> factor;
  factor.setThreshold(numerics::kRankThreshold);
  MatrixXd right = MatrixXd::Zero(A.rows(), m);
  right.bottomRows(m).setIdentity();
  double last = length;
  for (int i = 0; i < kIterations; ++i) {
    const auto placed = joints.place(x);
    VectorXd c = VectorXd::Zero(A.rows());
    c.head(joints.rows()) = joints.residual(placed, VectorXd());
    const double gap = largest_gap(c);
    if (!(gap < length)) return std::nullopt;
    A.topRows(joints.rows()) = joints.jacobian(placed);
    factor.compute(A);
    if (factor.rank() < A.cols()) return std::nullopt;
    if (i > 2 && !(gap < 0.5 * last)) break;
    last = gap;
    joints.move(x, -factor.solve(c));
  }
  if (last > 1e-11 * length) return std::nullopt;
  return MatrixXd(factor.solve(right));
}

}  // namespace

std::optional<BranchPoint> branch_point(const ConstraintSystem& joints,
                                        const Configuration& x,
                                        const VectorXd& along, int freedom) {
  const SingularPosition here(joints, x);
  BranchPoint point;
  point.coordinates = here.tangents(along);
  if (point.coordinates.cols() != freedom) return std::nullopt;
  const double size = along.lpNorm<Eigen::Infinity>();
  const double length = joints.scale({JointRow::Kind::kRotation});
  const double step = kApart * length;
  VectorXd shift = VectorXd::Zero(along.size());
  point.tangents = point.slopes = MatrixXd::Zero(along.size(), freedom);
  for (int k = 1; k <= kNodes; ++k) {
    for (const double sign : {-1.0, 1.0}) {
      const VectorXd way = (sign * k * step / size) * along;
      Configuration node = x;
      joints.move(node, way);
      const auto tangents = close_on_branch(joints, point.coordinates, node);
      if (!tangents) return std::nullopt;
      const VectorXd moved = joints.difference(x, node);
      // a quarter of the way aside is another branch
      if ((moved - way).norm() > 0.25 * way.norm()) return std::nullopt;
      shift += kMiddle[k - 1] * moved;
      point.tangents += kMiddle[k - 1] * *tangents;
      point.slopes += (sign * kSlope[k - 1] * size / step) * *tangents;
    }
  }
  point.x = x;
  joints.move(point.x, shift);
  return point;
}

}  // namespace clevis::mechanism
