#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/errors.h"
#include "mechanism/equations_of_motion/forward_dynamics.h"
#include "mechanism/line_elements/friction.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

constexpr double kRoundOff = 1e-9;
// Coming to rest costs a motion the last speed of a line, an error: so many
// times what steps may err by.
constexpr double kTimesError = 1e3;

/// @throws Error K011, always.
[[noreturn]] void refuse_wedge(double t) {
  throw Error("K011", "mechanism",
              fmt::format("at t = {:.9g} s dry friction wedges: whichever "
                          "joints rest or slip, one asks for the contrary",
                          t),
              "reduce the friction, or give it model = \"regularized\"; rigid "
              "bodies have no answer here");
}

}  // namespace

void ForwardDynamics::choose_modes(double t, const VectorXd& y) {
  place(t, y);
  add_loads(t, y);
  forces_.choose_modes();
  settle(t, y);
}

/// Lines whose speed is round-off come to rest together: friction in several
/// joints of one loop.
void ForwardDynamics::rest_what_hardly_moves() {
  const double fastest = std::max(speed_, u_.lpNorm<Eigen::Infinity>());
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    if (std::abs(forces_.element(k).modes[0]) != 1 || !forces_.is_dry(k)) {
      continue;
    }
    const double size = forces_.is_angle(k) ? length_ : 1.0;
    if (size * std::abs(forces_.element(k).rate) <= kRoundOff * fastest) {
      forces_.set_mode(k, 0);
    }
  }
}

void ForwardDynamics::rest_or_turn(double t, VectorXd& y, std::size_t k) {
  if (!forces_.is_dry(k) || forces_.element(k).modes[0] != 0) return;
  before_rest_ = y;
  project(t, y);
  scratch_ = y - before_rest_;
  const double change =
      scratch_.segment(positions_, system_.columns()).lpNorm<Eigen::Infinity>();
  if (change <= kTimesError * tolerance_ * speed_) return;
  y = before_rest_;
  forces_.set_mode(k, kLetGo);
  rate(t, y, scratch_);
  forces_.set_mode(k, line_acceleration(k) > 0.0 ? 1 : -1);
}

/// Size of accelerations, free bodies' among them, of which round-off is a
/// part [m/s²].
double ForwardDynamics::acceleration_size() const {
  const double speed = u_.lpNorm<Eigen::Infinity>();
  const std::vector<Twist>& wrenches = applied_.wrenches();
  double size =
      acceleration_.lpNorm<Eigen::Infinity>() + speed * speed / length_;
  for (std::size_t i = 1; i < bodies_.size(); ++i) {
    const double turning = bodies_[i].turn_factor.squaredNorm() / length_;
    size = std::max({size, wrenches[i].v.norm() / applied_.mass(i),
                     wrenches[i].w.norm() * turning});
  }
  return size;
}

/// The sticking line that asks most of its friction gives its most instead, if
/// that is less. @return whether there was one.
bool ForwardDynamics::release_worst() {
  double worst = 1.0 + kRoundOff;
  std::size_t which = forces_.size();
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    if (!forces_.sticks(k)) continue;
    const double breakaway = forces_.breakaway(k);
    const double ratio =
        breakaway > 0.0 ? std::abs(forces_.element(k).effort) / breakaway : 2.0;
    if (ratio > worst) {
      worst = ratio;
      which = k;
    }
  }
  if (which == forces_.size()) return false;
  forces_.set_mode(which, forces_.element(which).effort > 0.0 ? -2 : 2);
  return true;
}

/// Acceleration of a line [m/s²], turns times length, as of rate().
double ForwardDynamics::line_acceleration(std::size_t k) const {
  return (forces_.is_angle(k) ? length_ : 1.0) *
         forces_.line_acceleration(k, system_.twists(acceleration_), twists_);
}

/// What the friction of a line at its most would do to its bodies if nothing
/// else held them, likewise.
double ForwardDynamics::free_acceleration(std::size_t k) const {
  const ActingElement& e = forces_.element(k);
  double sum = 0.0;
  const auto add = [&](int slot, const Twist& lever) {
    if (slot == 0) return;
    const auto at = static_cast<std::size_t>(slot);
    sum += lever.v.squaredNorm() / applied_.mass(at) +
           lever.w.squaredNorm() * bodies_[at].turn_factor.squaredNorm() /
               (length_ * length_);
  };
  add(e.line.a, e.levers.a);
  add(e.line.b, e.levers.b);
  return (forces_.is_angle(k) ? length_ : 1.0) * sum * std::abs(e.effort);
}

/// A line at its most slips unless the others hold it, that is, unless it
/// would rest even without its friction; it sticks if they carry it back.
/// @return whether one changed.
bool ForwardDynamics::judge_lines_at_their_most(double t, const VectorXd& y) {
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    const int mode = forces_.element(k).modes[0];
    if (!forces_.is_dry(k) || std::abs(mode) != 2) continue;
    const double round_off =
        kRoundOff * std::max(free_acceleration(k), acceleration_size());
    const double a = line_acceleration(k);
    forces_.set_mode(k, kLetGo);
    rate(t, y, scratch_);
    const double free = line_acceleration(k);
    const bool is_held = std::abs(free) <= round_off;
    const bool goes_back = a * mode < -2.0 * round_off;
    forces_.set_mode(k, is_held ? mode : goes_back ? 0 : mode / 2);
    rate(t, y, scratch_);
    if (!is_held) return true;
  }
  return false;
}

double ForwardDynamics::first_step(double t, const VectorXd& y) {
  constexpr double kPart = 0.05, kLong = 0.01;
  const double duration = length_ / slowest_;
  double step = 0.0;
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    const ActingElement& e = forces_.element(k);
    const double zone = e.stribeck_zone();
    if (!(zone > 0.0) || e.modes[1] != 1 || std::abs(e.modes[0]) != 1) continue;
    rate(t, y, scratch_);
    const double a = e.is_line() ? std::abs(line_acceleration(k)) / row_scale(k)
                                 : forces_.sliding_acceleration(
                                       k, system_.twists(acceleration_));
    const double through = kPart * zone / std::max(a, 1e-300);
    if (through > kLong * duration) continue;
    step = step > 0.0 ? std::min(step, through) : through;
  }
  return step;
}

void ForwardDynamics::settle(double t, const VectorXd& y) {
  rate(t, y, scratch_);
  rest_what_hardly_moves();
  const std::size_t most = 6 * forces_.size() + 2;
  for (std::size_t tries = 0; tries < most; ++tries) {
    rate(t, y, scratch_);
    if (!yield_one_of_several(t, y) && !free_what_cannot_stick(t, y) &&
        !release_worst() && !judge_lines_at_their_most(t, y)) {
      return;
    }
  }
  refuse_wedge(t);
}

}  // namespace clevis::mechanism
