// Lines at rest whose rows depend on one another, on joints and drives.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/QR>

#include "mechanism/drives/drive_law.h"
#include "mechanism/equations_of_motion/forward_dynamics.h"
#include "mechanism/line_elements/friction.h"
#include "numerics/factors/jacobian_factor.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double kRoundOff = 1e-9;
// A carried line that is accelerated by this part of speed² over length turns.
constexpr double kClearTurn = 1e-2;
// Part of a combination of rows above which a row takes part in it.
constexpr double kTakesPart = 1e-6;
constexpr double kMoment = 1e-6;  // of the duration

}  // namespace

/// Orthonormal combinations of rows that vanish: what may be added to the
/// multipliers.
MatrixXd ForwardDynamics::open_multipliers() const {
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> rows;
  rows.setThreshold(numerics::kRankThreshold);
  rows.compute(J_.topRows(rows_));
  const Index open = rows_ - rows.rank();
  MatrixXd free = MatrixXd::Zero(rows_, open);
  free.bottomRows(open).setIdentity();
  if (open > 0) free.applyOnTheLeft(rows.householderQ());
  return free;
}

void ForwardDynamics::share_among_sticking() {
  Index row = system_.rows(), count = 0;
  VectorXd ratio = VectorXd::Zero(rows_);
  VectorXd weight = VectorXd::Zero(rows_);
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    if (!forces_.brings_row(k)) continue;
    const double most = forces_.sticks(k) ? forces_.breakaway(k) : 0.0;
    if (most > 0.0) {
      weight[row] = row_scale(k) / most;
      ++count;
    }
    ++row;
  }
  if (count == 0) return;
  const MatrixXd free = open_multipliers();
  if (free.cols() == 0) return;
  ratio = weight.cwiseProduct(lambda_.head(rows_));
  const MatrixXd shares = weight.asDiagonal() * free;
  // combinations of joints' rows alone, which are redundant, have no part
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> sharing(shares.rows(),
                                                           shares.cols());
  sharing.setThreshold(kTakesPart * weight.maxCoeff() /
                       std::max(shares.norm(), 1e-300));
  sharing.compute(shares);
  lambda_.head(rows_) -= free * sharing.solve(ratio);
}

/// By row, how drives begin to move, at once or within a moment; else 0.
VectorXd ForwardDynamics::beginning_of_drives(double t) const {
  const double soon = t + kMoment * length_ / slowest_;
  VectorXd rates = VectorXd::Zero(rows_);
  for (std::size_t k = 0; k < drives_.size(); ++k) {
    const Index row = system_.joint_rows() + static_cast<Index>(k);
    const double now = target_rates_[row];
    const double scale =
        system_.scale(system_.row_list()[static_cast<std::size_t>(row)]);
    const double later =
        scale * drive_target(drives_[k], soon, BendSide::kBefore).rate;
    if (std::abs(now) <= kRoundOff * std::abs(later)) rates[row] = later;
  }
  return rates;
}

/// Several lines at rest that cannot all go on so, as joints and drives move or
/// begin to: as these push, the first to reach its most gives that.
/// @return whether there was one.
bool ForwardDynamics::yield_one_of_several(double t, const VectorXd& y) {
  if (mass_.rank() == rows_) return false;
  const MatrixXd free = open_multipliers();
  // multipliers grow along what the rows ask beyond what they can have
  VectorXd push = free * (free.transpose() * gamma_.head(rows_));
  if (push.lpNorm<Eigen::Infinity>() <= kRoundOff * acceleration_size()) {
    push = free * (free.transpose() * beginning_of_drives(t));
  }
  // what joints and drives still do counts before what they will do
  const VectorXd going = free * (free.transpose() * target_rates_.head(rows_));
  const bool goes_on =
      going.dot(push) < 0.0 &&
      going.norm() > kRoundOff * length_ / slowest_ * push.norm();
  if (goes_on) push = going;
  std::size_t first = forces_.size();
  const int mode = first_at_its_most(push, first);
  if (mode == 0) return false;
  forces_.set_mode(first, goes_on ? mode / 2 : mode);
  rate(t, y, scratch_);
  return true;
}

/// Of several lines at rest the one whose effort is the first to reach its
/// most as multipliers grow along `push`. @return its mode then; 0: there are
/// not several.
int ForwardDynamics::first_at_its_most(const VectorXd& push,
                                       std::size_t& first) const {
  const double least_part = kTakesPart * push.norm();
  double least = std::numeric_limits<double>::infinity();
  int mode = 0, taking_part = 0;
  Index row = system_.rows();
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    if (!forces_.brings_row(k)) continue;
    const double along = push[row++];
    if (!forces_.sticks(k) || !(std::abs(along) > least_part)) continue;
    ++taking_part;
    const double most = std::copysign(forces_.breakaway(k), along);
    const double way =
        (most - forces_.element(k).effort) / (row_scale(k) * along);
    if (way >= least) continue;
    least = way;
    first = k;
    mode = along < 0.0 ? 2 : -2;
  }
  return taking_part < 2 ? 0 : mode;
}

/// Whether joints and drives alone fix the speed of a line; the last rate() is
/// then that without what sticks.
bool ForwardDynamics::is_carried(double t, const VectorXd& y, std::size_t k) {
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    if (i != k && forces_.sticks(i)) others.push_back(i);
  }
  for (const std::size_t i : others) forces_.set_mode(i, kLetGo);
  forces_.set_mode(k, 0);
  rate(t, y, scratch_);
  const int with = mass_.rank();
  forces_.set_mode(k, kLetGo);
  rate(t, y, scratch_);
  const int without = mass_.rank();
  for (const std::size_t i : others) forces_.set_mode(i, 0);
  return with == without;
}

/// Mode of a sticking line whose row the others imply, which is let go. If they
/// move it, it slips; if joints and drives carry it, as a slider at its dead
/// centre or a driven joint at rest, it holds nothing until it moves.
int ForwardDynamics::mode_of_dependent_line(double t, const VectorXd& y,
                                            std::size_t k) {
  const double beside_others = line_acceleration(k);
  const double size = acceleration_size();
  const bool carried = is_carried(t, y, k);
  const double a = carried ? line_acceleration(k) : beside_others;
  // slower, it is left to the event of leaving rest
  const double clear = carried ? kClearTurn * speed_ * speed_ / length_ : 0.0;
  if (std::abs(a) > std::max(kRoundOff * size, clear)) return a > 0.0 ? 1 : -1;
  return carried ? kLetGo : 0;
}

/// @return whether there was a sticking line that can hold nothing.
bool ForwardDynamics::free_what_cannot_stick(double t, const VectorXd& y) {
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    if (!forces_.sticks(k)) continue;
    const int rank = mass_.rank();
    forces_.set_mode(k, kLetGo);
    rate(t, y, scratch_);
    const int mode = mass_.rank() == rank ? mode_of_dependent_line(t, y, k) : 0;
    forces_.set_mode(k, mode);
    rate(t, y, scratch_);
    if (mode != 0) return true;
  }
  return false;
}

}  // namespace clevis::mechanism
