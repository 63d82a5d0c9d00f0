#include "mechanism/constraints/continuation.h"

#include <algorithm>
#include <utility>

namespace clevis::mechanism {
namespace {

using Eigen::VectorXd;

// A prediction of second order that misses by more than this part of the
// step may lead to a neighbouring branch.
constexpr double kSmallMiss = 0.05;
constexpr double kShortestStep = 0x1p-40;

}  // namespace

ClosedConfiguration Continuation::close(
    Configuration x, const VectorXd& targets,
    const numerics::JacobianFactor* near) const {
  ClosedConfiguration closed;
  closed.x = std::move(x);
  closed.targets = targets;
  closed.placed = system_.place(closed.x);
  closed.gap = largest_gap(system_.residual(closed.placed, targets));
  add_jacobian(closed, near);
  return closed;
}

void Continuation::add_jacobian(ClosedConfiguration& closed,
                                const numerics::JacobianFactor* near) const {
  closed.jacobian = system_.jacobian(closed.placed);
  closed.factor.compute(closed.jacobian, near);
}

Configuration Continuation::predict(const ClosedConfiguration& from,
                                    const VectorXd& change) const {
  VectorXd b = VectorXd::Zero(system_.rows());
  b.tail(change.size()) = change;
  for (int i = system_.joint_rows(); i < system_.rows(); ++i) {
    b[i] *= system_.scale(system_.row_list()[static_cast<std::size_t>(i)].row);
  }
  VectorXd displacement = from.factor.solve(b);
  const VectorXd bias = system_.bias(from.placed, system_.twists(displacement));
  displacement -= 0.5 * from.factor.solve(bias);
  Configuration x = from.x;
  system_.move(x, displacement);
  return x;
}

bool Continuation::correct(ClosedConfiguration& to,
                           const numerics::JacobianFactor& nearby) const {
  constexpr int kMost = 12;
  const double length = system_.scale({JointRow::Kind::kRotation});
  const double round_off = 3e-14 * length;
  numerics::JacobianFactor own;
  const numerics::JacobianFactor* factor = &nearby;
  bool fresh = false;  // the last step was Newton's own
  double last = 0.0;
  for (int i = 0;; ++i) {
    to.placed = system_.place(to.x);
    const VectorXd c = system_.residual(to.placed, to.targets);
    to.gap = largest_gap(c);
    if (to.gap <= round_off) return true;
    if (!(to.gap < length)) return false;
    if (i == kMost) return to.gap <= tolerance_;
    const bool slow = i > 0 && to.gap > 0.1 * last;
    if (slow) {
      if (to.gap < tolerance_ && fresh) return true;  // all it can do
      own.compute(system_.jacobian(to.placed), &nearby);
      factor = &own;
    }
    fresh = slow;
    last = to.gap;
    system_.move(to.x, -factor->solve(c));
  }
}

bool Continuation::step(const ClosedConfiguration& from,
                        const VectorXd& targets,
                        ClosedConfiguration& to) const {
  const VectorXd change = targets - from.targets;
  const Configuration predicted = predict(from, change);
  to.x = predicted;
  to.targets = targets;
  if (!correct(to, from.factor) || !(to.gap <= tolerance_)) return false;
  add_jacobian(to, &from.factor);
  const double length = system_.scale({JointRow::Kind::kRotation});
  const double allowed =
      std::max(kSmallMiss * system_.distance(from.x, to.x), 1e-10 * length);
  if (system_.distance(predicted, to.x) > allowed) return false;
  // where rank is lost, the derivatives say nothing: the caller reports it
  return !to.factor.full_column_rank() ||
         system_.distance(predict(to, -change), from.x) <= allowed;
}

Continuation::Reached Continuation::follow(const ClosedConfiguration& from,
                                           const VectorXd& targets) const {
  Reached reached{{}, 0.0};
  const VectorXd start = from.targets;
  double length = 1.0;
  const ClosedConfiguration* at = &from;  // until a step is done
  ClosedConfiguration next;
  while (reached.part < 1.0) {
    const double end = std::min(1.0, reached.part + length);
    const bool last = end == 1.0;
    const VectorXd way =
        last ? targets : VectorXd(start + end * (targets - start));
    const bool accepted = step(*at, way, next);
    // an inner point without full rank cannot be left: go round it
    if (accepted && (last || next.factor.full_column_rank())) {
      std::swap(reached.at, next);
      at = &reached.at;
      reached.part = end;
      length *= 2.0;
      continue;
    }
    length *= accepted ? 0.7 : 0.5;
    if (length < kShortestStep) {
      if (at == &from) reached.at = from;
      return reached;
    }
  }
  return reached;
}

}  // namespace clevis::mechanism
