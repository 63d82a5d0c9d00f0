// The change points of a driven motion.
#include <algorithm>
#include <iterator>
#include <utility>

#include <Eigen/QR>

#include "mechanism/definition/drive_names.h"
#include "mechanism/driven_motion/driven_motion.h"
#include "mechanism/drives/drive_law.h"
#include "mechanism/reactions/body_motion.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::MatrixXd;
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
std::optional<double> DrivenMotion::singular_between(const Moment& from,
                                                     const Moment& to,
                                                     int& halvings) const {
  const auto remains = [](const Moment& a, const Moment& b) {
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
  const Moment middle(follow(from, t), t);
  if (!middle.at.factor.full_column_rank()) return t;
  if (const auto hit = singular_between(from, middle, halvings)) return hit;
  return singular_between(middle, to, halvings);
}

/// The last regular moment on the way to a singular time, by bisection.
DrivenMotion::Moment DrivenMotion::edge(Moment regular, double singular) const {
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (regular.t + singular);
    ClosedConfiguration at = follow(regular, middle);
    if (at.factor.full_column_rank()) {
      regular = Moment(std::move(at), middle);
    } else {
      singular = middle;
    }
  }
  return regular;
}

/// Values by drive, scaled as the rows are.
VectorXd DrivenMotion::drive_rows(const VectorXd& values) const {
  VectorXd rows = values;
  for (Index i = 0; i < rows.size(); ++i) {
    const auto row = static_cast<std::size_t>(system_.joint_rows() + i);
    rows[i] *= system_.scale(system_.row_list()[row]);
  }
  return rows;
}

/// Velocities G z and accelerations G z' + G' z of the branch G that the drives
/// ask for. @return nothing where they do not move along it.
std::optional<DrivenMotion::Rates> DrivenMotion::branch_rates(
    const BranchPoint& point, const VectorXd& along, double t) const {
  const auto placed = system_.place(point.x);
  const auto drives = static_cast<Index>(definition_.drives.size());
  const MatrixXd rows = system_.jacobian(placed).bottomRows(drives);
  const Eigen::ColPivHouseholderQR<MatrixXd> solver(rows * point.tangents);
  if (!solver.isInvertible()) return std::nullopt;
  VectorXd rate(drives), second(drives);
  for (Index i = 0; i < drives; ++i) {
    const DriveTarget target =
        drive_target(definition_.drives[static_cast<std::size_t>(i)], t);
    rate[i] = target.rate;
    second[i] = target.acceleration;
  }
  const VectorXd z = solver.solve(drive_rows(rate));
  const VectorXd v = point.tangents * z;
  const VectorXd curved =
      v.dot(along) / along.squaredNorm() * (point.slopes * z);
  Rates result;
  result.twists = system_.twists(v);
  const VectorXd bias = system_.bias(placed, result.twists).tail(drives);
  const VectorXd change =
      solver.solve(drive_rows(second) - bias - rows * curved);
  result.accelerations = system_.twists(curved + point.tangents * change);
  return result;
}

/// An instant at a change point, with the forces of joints that give way.
/// @param along  velocity, or a direction of it, on the branch.
std::optional<Instant> DrivenMotion::on_branch(const Configuration& x,
                                               const VectorXd& along,
                                               double t) const {
  const auto drives = static_cast<int>(definition_.drives.size());
  const auto point = branch_point(joints_, x, along, drives);
  if (!point) return std::nullopt;
  const auto here = branch_rates(*point, along, t);
  if (!here) return std::nullopt;
  const ClosedConfiguration at =
      continuation_.close(point->x, drive_positions(definition_, t));
  Instant result = kinematics(at, t, *here);
  const std::vector<Twist> applied = elements(at, *here, result);
  auto forces = equilibrium_.solve_compliant(at.x, at.placed, here->twists,
                                             here->accelerations, applied);
  if (!forces) return std::nullopt;
  put_forces(frame_, system_, at.placed, std::move(*forces), result);
  result.is_change_point = true;
  return result;
}

/// The change point at t, just behind a regular moment.
std::optional<Instant> DrivenMotion::change_point(const Moment& before,
                                                  double t) const {
  const ClosedConfiguration at = follow(before, t);
  const auto drives = static_cast<Index>(definition_.drives.size());
  VectorXd change(drives);
  for (Index i = 0; i < drives; ++i) {
    change[i] =
        drive_target(definition_.drives[static_cast<std::size_t>(i)], t).rate;
  }
  const bool rests = drive_rows(change).lpNorm<Eigen::Infinity>() <
                     1e-9 * frame_.length / std::max(t, 1e-300);
  if (rests) change = at.targets - before.at.targets;
  VectorXd right = VectorXd::Zero(system_.rows());
  right.tail(drives) = drive_rows(change);
  const VectorXd along = before.at.factor.solve(right);
  if (along.isZero(0.0)) return std::nullopt;
  return on_branch(at.x, along, t);
}

/// Notes the change points between two regular moments.
void DrivenMotion::note_change_points(const Moment& from, const Moment& to,
                                      AtSingularity policy,
                                      Motion& motion) const {
  Moment at = from;
  int halvings = kHalvings;
  while (const auto hit = singular_between(at, to, halvings)) {
    const Moment before = edge(at, *hit);
    Moment behind = edge(to, *hit);
    const double t = 0.5 * (before.t + behind.t);
    if (policy == AtSingularity::kStop) {
      refuse_change_point(follow(before, t), t);
    }
    motion.change_points.push_back({t, t, t, change_point(before, t)});
    at = std::move(behind);
  }
}

/// Notes a change point at which a step ended, and those beside it.
/// @param next  the next regular moment, or none.
void DrivenMotion::settle(const Moment& last, double singular,
                          const Moment* next, AtSingularity policy,
                          Motion& motion) const {
  const Moment before = edge(last, singular);
  note_change_points(last, before, policy, motion);
  double t = singular;
  std::optional<Moment> behind;
  if (next) {
    behind = edge(*next, singular);
    t = 0.5 * (before.t + behind->t);
  }
  if (policy == AtSingularity::kStop) {
    refuse_change_point(follow(before, t), t);
  }
  motion.change_points.push_back({t, t, t, change_point(before, t)});
  if (next) note_change_points(*behind, *next, policy, motion);
}

}  // namespace clevis::mechanism
