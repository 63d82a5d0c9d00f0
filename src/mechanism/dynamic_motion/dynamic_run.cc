#include "mechanism/dynamic_motion/dynamic_run.h"

#include <algorithm>
#include <utility>

#include "mechanism/drives/drive_law.h"
#include "mechanism/dynamic_motion/initial_state.h"
#include "mechanism/reactions/power_balance.h"
#include "mechanism/sampling/driven_sampling.h"

namespace clevis::mechanism {
namespace {

using Eigen::VectorXd;

// Local errors add up over a motion; steps are this much stricter, down to
// round-off, and of closed loops to where that governs beside change points.
constexpr double kLocalPart = 0.01;
constexpr double kStrictest = 1e-14, kStrictestOfLoops = 1e-11;

double step_tolerance(const SolvingFrame& frame, double tolerance) {
  return std::max(kLocalPart * tolerance,
                  frame.is_tree ? kStrictest : kStrictestOfLoops);
}

std::vector<double> sample_times(const SimulationSettings& settings,
                                 const std::vector<double>& others) {
  std::vector<double> times = uniform_times(settings);
  add_times(others, settings.duration, times);
  return times;
}

}  // namespace

DynamicRun::DynamicRun(const MechanismDefinition& definition,
                       const SimulationSettings& settings,
                       const std::vector<double>& others)
    : definition_(definition),
      settings_(settings),
      frame_(frame_at_centres(definition)),
      dynamics_(definition, frame_, step_tolerance(frame_, settings.tolerance),
                settings.duration),
      equilibrium_(definition, frame_, dynamics_.system()),
      change_points_(definition, settings, frame_, dynamics_, equilibrium_),
      integrator_(definition, frame_, dynamics_, settings.integrator),
      resampler_(definition, frame_, dynamics_, settings.integrator),
      events_(dynamics_, definition),
      impacts_(dynamics_),
      sample_times_(sample_times(settings, others)) {}

void DynamicRun::start() {
  const InitialState initial =
      initial_state(definition_, frame_, dynamics_.system(),
                    settings_.tolerance * frame_.length);
  y_ = dynamics_.start(initial.x);
  y_.segment(dynamics_.velocity_index(), initial.velocities.size()) =
      initial.velocities;
  event_values_.setOnes(dynamics_.forces().events());
  find_breaks();
  dynamics_.enter_piece(0.0);
  dynamics_.project(0.0, y_);
  dynamics_.communicate(0.0, y_);
  stick_slip_.choose_modes(0.0, y_);
  dynamics_.project(0.0, y_);
  dynamics_.accept(0.0, y_);
  slope_.setZero(y_.size());
  sample_ = y_;
  dynamics_.rate(0.0, y_, slope_);
  dynamics_.note_speed(y_);
  energy_start_ = dynamics_.kinetic_energy(y_);
  change_points_.start(initial, y_);
  restart(0.0);
}

void DynamicRun::find_breaks() {
  breaks_ = dynamics_.forces().kink_times();
  jumps_ = drive_jumps(definition_.drives, settings_.duration);
  for (const DriveDefinition& drive : definition_.drives) {
    breaks_.push_back(drive.start);
    breaks_.push_back(drive.start + drive.duration);
    for (const double t : drive.table.times) {
      breaks_.push_back(drive.start + t);
    }
  }
  std::ranges::sort(breaks_);
}

double DynamicRun::next_break() const {
  const double now = integrator_.t();
  const auto next = std::ranges::upper_bound(breaks_, now);
  const double bend = next == breaks_.end() ? settings_.duration : *next;
  return std::min({bend, dynamics_.next_communication(), settings_.duration});
}

void DynamicRun::pass(const EventFinder::Event& event) {
  const double t = event.t;
  guard_against_accumulation(t);
  if (sampler_) want_sides(t);
  sample_until(t);
  state_at(t, y_);
  dynamics_.project(t, y_);  // what stuck rests, without round-off
  change_points_.look(integrator_, t, y_);
  dynamics_.event_values(t, y_, event_values_);
  ForceModel& forces = dynamics_.forces();
  const std::vector<int> before = forces.modes();
  forces.pass_event(event.index);
  stick_slip_.rest_or_turn(t, y_, static_cast<std::size_t>(event.index / 2));
  stick_slip_.settle(t, y_);
  dynamics_.project(t, y_);
  dynamics_.accept(t, y_);
  impacts_.pass(t, y_, before);
  for (MotionEvent& change : forces.changes(event.index, t, before)) {
    motion_.events.push_back(std::move(change));
  }
  restart(t);
}

/// A time at which laws of drives or tables bend, or gas communicates.
void DynamicRun::pass_bend(double t) {
  dynamics_.communicate(t, y_);
  dynamics_.enter_piece(t);
  if (std::ranges::find(jumps_, t, &DriveJump::t) != jumps_.end()) {
    dynamics_.jump(t, y_);
    stick_slip_.choose_modes(t, y_);
    dynamics_.project(t, y_);
    dynamics_.accept(t, y_);
  } else {
    stick_slip_.settle(t, y_);  // what rests may have to yield to a drive
  }
  restart(t);
}

void DynamicRun::restart(double t) {
  events_.start(t, y_);
  if (peaks_) peaks_->restart(t, y_);
  if (sampler_) sampler_->restart(t, y_);
  change_points_.restart(y_);
  integrator_.restart(t, y_, stick_slip_.first_step(t, y_));
}

Motion DynamicRun::run() {
  start();
  sample_until(0.0);
  while (integrator_.t() < settings_.duration) {
    const double limit = next_break();
    if (!integrator_.step(limit)) {
      refuse_stuck();
    }
    require_few(integrator_.counts());
    const EventFinder::Event event = events_.find(integrator_);
    if (peaks_) {
      peaks_->look(integrator_, event.index < 0 ? integrator_.t() : event.t);
    }
    impacts_.look(integrator_, event.index < 0 ? integrator_.t() : event.t);
    if (sampler_) add_wanted(event.index < 0 ? integrator_.t() : event.t);
    if (event.index >= 0) {
      pass(event);
      continue;
    }
    sample_until(integrator_.t());
    y_ = integrator_.y();
    require_closed(integrator_.t(), dynamics_.project(integrator_.t(), y_));
    dynamics_.accept(integrator_.t(), y_);
    dynamics_.note_speed(y_);
    change_points_.look(integrator_, integrator_.t(), y_);
    integrator_.correct(y_);
    note_energy(y_);
    step_energy_error_ = std::max(step_energy_error_, energy_gap(y_));
    require_resisting_friction();
    if (integrator_.t() == limit && limit < settings_.duration) {
      pass_bend(limit);
    }
  }
  change_points_.finish();
  require_energy_balance();
  const numerics::StepCounts& counts = integrator_.counts();
  motion_.integration = IntegrationSummary{
      .method = integrator_.method(),
      .steps = counts.steps,
      .rejected = counts.rejected,
      .evaluations = counts.evaluations + resampler_.counts().evaluations,
      .factorisations = counts.factorisations,
      .implicit_steps = integrator_.implicit_steps(),
      .energy_error = energy_error_,
      .relative_energy_error =
          largest_energy_ > 0.0 ? energy_error_ / largest_energy_ : 0.0};
  motion_.change_points = std::move(change_points_).among(motion_.instants);
  motion_.impacts = impacts_.impacts();
  judge_power_balance(definition_, motion_);
  return std::move(motion_);
}

}  // namespace clevis::mechanism
