#include "mechanism/events/stick_slip.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "mechanism/drives/drive_law.h"
#include "mechanism/forces/element_modes.h"
#include "mechanism/forces/given_efforts.h"
#include "mechanism/forces/line_motion.h"
#include "mechanism/line_elements/friction.h"

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
// Coming to rest costs a motion the last speed of a line, an error: so many
// times what steps may err by.
constexpr double kTimesError = 1e3;

/// @throws Error K011, always.
[[noreturn]] void refuse_inconsistent_friction(double t) {
  throw Error("K011", "mechanism",
              fmt::format("at t = {:.9g} s dry friction wedges: whichever "
                          "joints rest or slip, one asks for the contrary",
                          t),
              "Reduce the friction, or give it model = \"regularized\"; rigid "
              "bodies have no answer here.");
}

}  // namespace

StickSlip::StickSlip(ForwardDynamics& dynamics)
    : equations_(dynamics.equations()),
      constraints_(equations_.constraints()),
      projection_(dynamics.projection()),
      scales_(dynamics.state_scales()),
      forces_(equations_.forces()) {}

void StickSlip::choose_modes(double t, const VectorXd& y) {
  const MechanismState& state = equations_.evaluate_forces(t, y);
  mechanism::choose_modes(state.loads.forces, forces_);
  resolve_modes(t, y);
}

/// Stops all slipping elements whose speed is round-off: friction in several
/// joints of one loop comes to rest at once.
void StickSlip::stop_what_hardly_moves() {
  const double fastest =
      std::max(scales_.largest_speed(),
               equations_.state().speeds.lpNorm<Eigen::Infinity>());
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    if (std::abs(forces_.element(k).modes[0]) != 1 ||
        !forces_.element(k).is_dry()) {
      continue;
    }
    const double size = constraints_.row_scale(k);
    if (size * std::abs(acting(k).rate) <= kRoundOff * fastest) {
      forces_.element(k).modes[0] = 0;
    }
  }
}

void StickSlip::stop_or_reverse(double t, VectorXd& y, std::size_t k) {
  if (!forces_.element(k).is_dry() || forces_.element(k).modes[0] != 0) return;
  const VectorXd before = y;
  projection_.project(t, y);
  const VectorXd moved = y - before;
  const double change = equations_.layout().largest_speed(moved);
  if (change <= kTimesError * scales_.tolerance() * scales_.largest_speed())
    return;
  y = before;
  forces_.element(k).modes[0] = kOmitted;
  equations_.solve(t, y);
  forces_.element(k).modes[0] = line_acceleration(k) > 0.0 ? 1 : -1;
}

/// Size of accelerations, free bodies' among them, of which round-off is a
/// part [m/s²].
double StickSlip::acceleration_size() const {
  const double speed = equations_.state().speeds.lpNorm<Eigen::Infinity>();
  const std::vector<SpatialForce>& wrenches = equations_.state().loads.wrenches;
  double size = equations_.solution().accelerations.lpNorm<Eigen::Infinity>() +
                speed * speed / equations_.layout().length();
  for (std::size_t i = 1; i < wrenches.size(); ++i) {
    const double turning = equations_.inertias().turn_factor(i).squaredNorm() /
                           equations_.layout().length();
    size = std::max({size, wrenches[i].v.norm() / equations_.inertias().mass(i),
                     wrenches[i].w.norm() * turning});
  }
  return size;
}

/// Switches the sticking element with the largest ratio of required to
/// breakaway force, if that is above 1, to its breakaway force. @return whether
/// there was one.
bool StickSlip::release_most_loaded() {
  double worst = 1.0 + kRoundOff;
  std::size_t which = forces_.size();
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    if (!forces_.element(k).sticks()) continue;
    const double breakaway = forces_.element(k).breakaway(acting(k));
    const double ratio =
        breakaway > 0.0 ? std::abs(acting(k).effort) / breakaway : 2.0;
    if (ratio > worst) {
      worst = ratio;
      which = k;
    }
  }
  if (which == forces_.size()) return false;
  forces_.element(which).modes[0] = acting(which).effort > 0.0 ? -2 : 2;
  return true;
}

/// Acceleration of a line [m/s²], turns times length, as of solve().
double StickSlip::line_acceleration(std::size_t k) const {
  return constraints_.row_scale(k) *
         mechanism::line_acceleration(
             forces_.element(k), acting(k),
             equations_.system().twists(equations_.solution().accelerations),
             equations_.state().twists);
}

/// Acceleration that the breakaway force of a line would cause if nothing else
/// held its bodies [m/s²], turns times length.
double StickSlip::free_acceleration(std::size_t k) const {
  const JointModel& line = forces_.element(k).line;
  const ElementResponse& e = acting(k);
  double sum = 0.0;
  const auto add = [&](int slot, const SpatialForce& lever) {
    if (slot == 0) return;
    const auto at = static_cast<std::size_t>(slot);
    sum += lever.v.squaredNorm() / equations_.inertias().mass(at) +
           lever.w.squaredNorm() *
               equations_.inertias().turn_factor(at).squaredNorm() /
               (equations_.layout().length() * equations_.layout().length());
  };
  add(line.a, e.levers.a);
  add(line.b, e.levers.b);
  return constraints_.row_scale(k) * sum * std::abs(e.effort);
}

/// Judges elements at their breakaway force, all by the same motion: their
/// order must not decide. Such an element stays so if it would rest even
/// without its friction, sticks again if it accelerates against its sense, and
/// slips otherwise, as soon as none sticks again.
/// @return whether one changed.
bool StickSlip::judge_lines_at_breakaway(double t, const VectorXd& y) {
  std::vector<std::size_t> going_back, slipping;
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    const int mode = forces_.element(k).modes[0];
    if (!forces_.element(k).is_dry() || std::abs(mode) != 2) continue;
    const double round_off =
        kRoundOff * std::max(free_acceleration(k), acceleration_size());
    const double a = line_acceleration(k);
    forces_.element(k).modes[0] = kOmitted;
    equations_.solve(t, y);
    const double free = line_acceleration(k);
    const bool is_held = std::abs(free) <= round_off;
    const bool goes_back = a * mode < -2.0 * round_off;
    forces_.element(k).modes[0] = mode;
    equations_.solve(t, y);
    if (!is_held) (goes_back ? going_back : slipping).push_back(k);
  }
  for (const std::size_t k : going_back) forces_.element(k).modes[0] = 0;
  if (!going_back.empty()) return true;
  for (const std::size_t k : slipping) forces_.element(k).modes[0] /= 2;
  return !slipping.empty();
}

double StickSlip::first_step(double t, const VectorXd& y) {
  constexpr double kPart = 0.05, kLong = 0.01;
  const double duration =
      equations_.layout().length() / scales_.slowest_speed();
  double step = 0.0;
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    const ActingElement& e = forces_.element(k);
    const double zone = e.stribeck_zone();
    if (!(zone > 0.0) || e.modes[1] != 1 || std::abs(e.modes[0]) != 1) continue;
    equations_.solve(t, y);
    const double a =
        e.is_line()
            ? std::abs(line_acceleration(k)) / constraints_.row_scale(k)
            : sliding_acceleration(e, acting(k),
                                   equations_.system().twists(
                                       equations_.solution().accelerations));
    const double through = kPart * zone / std::max(a, 1e-300);
    if (through > kLong * duration) continue;
    step = step > 0.0 ? std::min(step, through) : through;
  }
  return step;
}

void StickSlip::resolve_modes(double t, const VectorXd& y) {
  equations_.solve(t, y);
  stop_what_hardly_moves();
  const std::size_t most = 6 * forces_.size() + 2;
  for (std::size_t tries = 0; tries < most; ++tries) {
    equations_.solve(t, y);
    if (!release_first_of_dependent(t, y) && !release_dependent_lines(t, y) &&
        !release_most_loaded() && !judge_lines_at_breakaway(t, y)) {
      return;
    }
  }
  refuse_inconsistent_friction(t);
}

/// Rates, by row, of drives that start from rest at once or within kMoment;
/// else 0.
VectorXd StickSlip::beginning_of_drives(double t) const {
  const double soon =
      t + kMoment * equations_.layout().length() / scales_.slowest_speed();
  const std::vector<DriveDefinition>& drives = equations_.drives().drives();
  VectorXd rates = VectorXd::Zero(constraints_.rows());
  const ConstraintSystem& system = equations_.system();
  for (std::size_t k = 0; k < drives.size(); ++k) {
    const Index row = system.joint_rows() + static_cast<Index>(k);
    const double now = equations_.targets().row_rates[row];
    const double scale =
        system.scale(system.row_list()[static_cast<std::size_t>(row)]);
    const double later =
        scale * drive_target(drives[k], soon, BreakpointSide::kBefore).rate;
    if (std::abs(now) <= kRoundOff * std::abs(later)) rates[row] = later;
  }
  return rates;
}

/// Where joints and drives that move or begin to over-constrain sticking
/// elements: increases the multipliers along the infeasible direction until the
/// first element reaches its breakaway force.
/// @return whether there was one.
bool StickSlip::release_first_of_dependent(double t, const VectorXd& y) {
  if (constraints_.mass().rank() == constraints_.rows()) return false;
  const MatrixXd free = constraints_.open_multipliers();
  // multipliers grow along what the rows ask beyond what they can have
  VectorXd push =
      free * (free.transpose() * equations_.solution().row_accelerations.head(
                                     constraints_.rows()));
  if (push.lpNorm<Eigen::Infinity>() <= kRoundOff * acceleration_size()) {
    push = free * (free.transpose() * beginning_of_drives(t));
  }
  // what joints and drives still do counts before what they will do
  const VectorXd going =
      free * (free.transpose() *
              equations_.targets().row_rates.head(constraints_.rows()));
  const bool goes_on = going.dot(push) < 0.0 &&
                       going.norm() > kRoundOff * equations_.layout().length() /
                                          scales_.slowest_speed() * push.norm();
  if (goes_on) push = going;
  std::size_t first = forces_.size();
  const int mode = first_at_breakaway(push, first);
  if (mode == 0) return false;
  forces_.element(first).modes[0] = goes_on ? mode / 2 : mode;
  equations_.solve(t, y);
  return true;
}

/// Finds the sticking element that is the first to reach its breakaway force as
/// multipliers grow along `push`. @return its mode then; 0: fewer than two take
/// part.
int StickSlip::first_at_breakaway(const VectorXd& push,
                                  std::size_t& first) const {
  const double least_part = kTakesPart * push.norm();
  double least = std::numeric_limits<double>::infinity();
  int mode = 0, taking_part = 0;
  Index row = equations_.system().rows();
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    if (!brings_row(forces_.element(k))) continue;
    const double along = push[row++];
    if (!forces_.element(k).sticks() || !(std::abs(along) > least_part))
      continue;
    ++taking_part;
    const double most =
        std::copysign(forces_.element(k).breakaway(acting(k)), along);
    const double way =
        (most - acting(k).effort) / (constraints_.row_scale(k) * along);
    if (way >= least) continue;
    least = way;
    first = k;
    mode = along < 0.0 ? 2 : -2;
  }
  return taking_part < 2 ? 0 : mode;
}

/// Whether joints and drives alone fix the speed of a line. Leaves the last
/// solve() without sticking elements.
bool StickSlip::is_carried(double t, const VectorXd& y, std::size_t k) {
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    if (i != k && forces_.element(i).sticks()) others.push_back(i);
  }
  for (const std::size_t i : others) forces_.element(i).modes[0] = kOmitted;
  forces_.element(k).modes[0] = 0;
  equations_.solve(t, y);
  const int with = constraints_.mass().rank();
  forces_.element(k).modes[0] = kOmitted;
  equations_.solve(t, y);
  const int without = constraints_.mass().rank();
  for (const std::size_t i : others) forces_.element(i).modes[0] = 0;
  return with == without;
}

/// Mode of a sticking line whose row depends on the others and is omitted. It
/// slips if they accelerate it. If joints and drives carry it, as a slider at
/// its dead centre or a driven joint at rest, it exerts no friction until it
/// moves.
int StickSlip::mode_of_dependent_line(double t, const VectorXd& y,
                                      std::size_t k) {
  const double beside_others = line_acceleration(k);
  const double size = acceleration_size();
  const bool carried = is_carried(t, y, k);
  const double a = carried ? line_acceleration(k) : beside_others;
  // slower, it is left to the event of leaving rest
  const double clear = carried ? kClearTurn * scales_.largest_speed() *
                                     scales_.largest_speed() /
                                     equations_.layout().length()
                               : 0.0;
  if (std::abs(a) > std::max(kRoundOff * size, clear)) return a > 0.0 ? 1 : -1;
  return carried ? kOmitted : 0;
}

/// @return whether there was a sticking line that can hold nothing.
bool StickSlip::release_dependent_lines(double t, const VectorXd& y) {
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    if (!forces_.element(k).sticks()) continue;
    const int rank = constraints_.mass().rank();
    forces_.element(k).modes[0] = kOmitted;
    equations_.solve(t, y);
    const int mode = constraints_.mass().rank() == rank
                         ? mode_of_dependent_line(t, y, k)
                         : 0;
    forces_.element(k).modes[0] = mode;
    equations_.solve(t, y);
    if (mode != 0) return true;
  }
  return false;
}

}  // namespace clevis::mechanism
