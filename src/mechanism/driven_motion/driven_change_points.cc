#include "mechanism/driven_motion/driven_change_points.h"

#include <algorithm>
#include <utility>

#include "base/values/index.h"
#include "mechanism/definition/drive_names.h"
#include "mechanism/drives/drive_law.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

// of the time between two instants, in search of change points
constexpr int kHalvings = 300;

}  // namespace

/// A time between two positions at which J loses rank, if there is one. Its
/// smallest singular value with its sign tells: u, v those of one end, uᵀ J v
/// at the other end is negative behind a change point. Where it has changed by
/// half, the interval is halved. det J tells of others that pass zero; it keeps
/// its sign where two loops lose rank at once, and redundant mechanisms have
/// none.
/// @param halvings  left to do.
std::optional<double> DrivenChangePoints::singular_between(
    const DrivenMoment& from, const DrivenMoment& to, int& halvings) const {
  const auto remains = [](const DrivenMoment& a, const DrivenMoment& b) {
    const numerics::JacobianFactor::Weakest w = a.at.factor.weakest();
    return w.u.dot(b.at.jacobian * w.v) > 0.5 * w.sigma;
  };
  const bool same_sign =
      from.at.factor.determinant_sign() == to.at.factor.determinant_sign();
  if ((same_sign && remains(from, to) && remains(to, from)) || halvings == 0) {
    return std::nullopt;
  }
  --halvings;
  const double t = 0.5 * (from.t + to.t);
  const DrivenMoment middle(model_.follow(from, t), t);
  if (!middle.at.factor.full_column_rank()) return t;
  if (const auto hit = singular_between(from, middle, halvings)) return hit;
  return singular_between(middle, to, halvings);
}

/// The last regular moment on the way to a singular time, by bisection.
DrivenMoment DrivenChangePoints::edge(DrivenMoment regular,
                                      double singular) const {
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (regular.t + singular);
    ClosedConfiguration at = model_.follow(regular, middle);
    if (at.factor.full_column_rank()) {
      regular = DrivenMoment(std::move(at), middle);
    } else {
      singular = middle;
    }
  }
  return regular;
}

/// The change point at t, just behind a regular moment.
std::optional<Instant> DrivenChangePoints::just_behind(
    const DrivenMoment& before, double t) {
  const ClosedConfiguration at = model_.follow(before, t);
  const auto drives = static_cast<Index>(model_.definition.drives.size());
  VectorXd change(drives);
  for (Index i = 0; i < drives; ++i) {
    change[i] = drive_target(model_.definition.drives[index(i)], t).rate;
  }
  const bool rests = model_.drive_rows(change).lpNorm<Eigen::Infinity>() <
                     1e-9 * model_.frame.length / std::max(t, 1e-300);
  if (rests) change = at.targets - before.at.targets;
  VectorXd right = VectorXd::Zero(model_.system.rows());
  right.tail(drives) = model_.drive_rows(change);
  const VectorXd along = before.at.factor.solve(right);
  if (along.isZero(0.0)) return std::nullopt;
  return instants_.singular(at.x, along, t);
}

std::optional<Instant> DrivenChangePoints::instant(const DrivenMoment& last,
                                                   double singular) {
  return just_behind(edge(last, singular), singular);
}

void DrivenChangePoints::note(const DrivenMoment& before, double t,
                              Motion& motion) {
  if (policy_ == AtSingularity::kStop) {
    model_.refuse_change_point(model_.follow(before, t), t);
  }
  motion.change_points.push_back({t, t, t, just_behind(before, t)});
}

void DrivenChangePoints::note_between(const DrivenMoment& from,
                                      const DrivenMoment& to, Motion& motion) {
  DrivenMoment at = from;
  int halvings = kHalvings;
  while (const auto hit = singular_between(at, to, halvings)) {
    const DrivenMoment before = edge(at, *hit);
    DrivenMoment behind = edge(to, *hit);
    note(before, 0.5 * (before.t + behind.t), motion);
    at = std::move(behind);
  }
}

void DrivenChangePoints::note_singular(const DrivenMoment& last,
                                       double singular,
                                       const DrivenMoment* next,
                                       Motion& motion) {
  const DrivenMoment before = edge(last, singular);
  note_between(last, before, motion);
  if (!next) return note(before, singular, motion);
  const DrivenMoment behind = edge(*next, singular);
  note(before, 0.5 * (before.t + behind.t), motion);
  note_between(behind, *next, motion);
}

}  // namespace clevis::mechanism
