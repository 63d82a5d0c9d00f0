// Instants of an integrated motion: when, and what they hold.
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "mechanism/dynamic_motion/dynamic_run.h"
#include "mechanism/reactions/body_motion.h"
#include "mechanism/reactions/held_lines.h"
#include "mechanism/reactions/reaction_friction.h"
#include "mechanism/sampling/driven_sampling.h"
#include "numerics/factors/jacobian_factor.h"

namespace clevis::mechanism {
namespace {

using Eigen::VectorXd;

// Instants on both sides of more events than this would only crowd.
constexpr int kMostTwoSided = 1000;

}  // namespace

bool DynamicRun::Beside::contains(double t) const {
  return std::ranges::any_of(change_points, [&](double point) {
    return std::abs(point - t) <= reach;
  });
}

/// Instants that the loads of the last step call for.
void DynamicRun::add_wanted(double until) {
  wanted_.clear();
  sampler_->look(integrator_, until,
                 std::span(sample_times_).subspan(next_sample_), wanted_);
  std::erase_if(wanted_, [this](double t) {
    return beside_.contains(t);
  });
  add_times(wanted_, settings_.duration, sample_times_);
}

/// Instants just before and behind a time at which loads may jump. That
/// before is at the time itself where the modes change only then.
void DynamicRun::want_sides(double t) {
  const double side = kSides * settings_.duration;
  if (t < side || t + side > settings_.duration ||
      two_sided_++ >= kMostTwoSided) {
    return;
  }
  add_times({t, t + side}, settings_.duration, sample_times_);
}

void DynamicRun::add_instant(double t, VectorXd& y) {
  const double gap = dynamics_.project(t, y);
  require_closed(t, gap);
  dynamics_.rate(t, y, slope_);
  note_energy(y);
  const ConstraintSystem& system = dynamics_.system();
  const auto placed = system.place(dynamics_.configuration());
  auto accelerations = system.twists(dynamics_.accelerations());
  numerics::JacobianFactor factor;
  factor.compute(system.jacobian(placed), nullptr, frame_.rank_threshold());
  const bool is_change_point = factor.rank() < change_points_.rank();
  std::optional<Equilibrium::Solution> forces;
  if (is_change_point) {
    if (auto found = change_points_.on_branch(t, y)) {
      accelerations = std::move(found->accelerations);
      forces = std::move(found->forces);
    }
  }
  if (!forces) {
    std::vector<Twist> applied(dynamics_.twists().size());
    dynamics_.forces().add_to(applied);
    forces = equilibrium_.solve(dynamics_.configuration(), placed, factor,
                                dynamics_.twists(), accelerations, applied);
  }
  Instant instant = motion_at(definition_, frame_, dynamics_, t, accelerations);
  put_forces(frame_, system, placed, std::move(*forces), instant);
  mark_what_friction_leaves_open(frame_, system, placed, dynamics_.forces(),
                                 instant);
  instant.is_change_point = is_change_point;
  require_unique_loads(definition_, dynamics_.forces(), instant.joints);
  instant.closure_error = gap;
  motion_.instants.push_back(std::move(instant));
}

/// Whether a state within the last step has another energy than the steps have:
/// not than other instants within steps, of which many would loosen this.
bool DynamicRun::misses_energy(double t, VectorXd& y) {
  dynamics_.project(t, y);
  const double kinetic = dynamics_.kinetic_energy(y);
  const double work = y[dynamics_.work_index()];
  const double largest = std::max({largest_energy_, kinetic, std::abs(work)});
  return energy_gap(y) > step_energy_error_ + settings_.tolerance * largest;
}

/// State within the last step: by dense output, but beside a change point or in
/// an impact, where that may be rough, by steps of its own.
void DynamicRun::state_at(double t, VectorXd& y) {
  integrator_.state_at(t, y);
  if (!misses_energy(t, y)) return;
  const double start = integrator_.t_start();
  integrator_.state_at(start, y);
  dynamics_.project(start, y);
  resampler_.restart(start, y, t - start);
  constexpr int kMost = 1000;  // else the motion is rough beyond help
  for (int i = 0; resampler_.t() < t; ++i) {
    if (i == kMost || !resampler_.step(t)) return integrator_.state_at(t, y);
  }
  y = resampler_.y();
}

void DynamicRun::sample_until(double t) {
  while (next_sample_ < sample_times_.size() &&
         sample_times_[next_sample_] <= t) {
    const double at = sample_times_[next_sample_++];
    if (at >= integrator_.t()) {
      sample_ = integrator_.y();
    } else {
      state_at(at, sample_);
    }
    add_instant(at, sample_);
  }
}

}  // namespace clevis::mechanism
