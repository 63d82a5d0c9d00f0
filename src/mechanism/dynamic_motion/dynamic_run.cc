#include "mechanism/dynamic_motion/dynamic_run.h"

#include <algorithm>
#include <utility>

#include "mechanism/events/touch_at_start.h"
#include "mechanism/forces/element_modes.h"
#include "mechanism/integration/initial_state.h"
#include "mechanism/reactions/power_balance.h"
#include "mechanism/reactions/reaction_friction.h"

namespace clevis::mechanism {

DynamicRun::DynamicRun(const MechanismDefinition& definition,
                       const SimulationSettings& settings, TimeLimit& limit,
                       const std::vector<double>& others)
    : model_(definition, settings),
      equations_(model_.equations),
      projection_(model_.projection),
      stick_slip_(model_.dynamics),
      breaks_(definition, equations_.forces(), settings.duration),
      change_points_(model_),
      integrator_(definition, model_.frame, model_.dynamics,
                  settings.integrator),
      energy_(model_),
      guards_(model_, change_points_, integrator_, limit),
      instants_(model_, change_points_, integrator_, energy_, guards_, others),
      events_(equations_, definition),
      impacts_(equations_) {}

void DynamicRun::start() {
  refuse_friction_beside_teeth(model_.definition, MovedBy::kForces);
  const InitialState initial =
      initial_state(model_.definition, model_.frame, equations_.system(),
                    model_.settings.tolerance * model_.frame.length);
  y_ = equations_.start(initial.x);
  y_.segment(equations_.layout().velocity_index(), initial.velocities.size()) =
      initial.velocities;
  equations_.enter_piece(0.0);
  projection_.project(0.0, y_);
  communicate(0.0);
  stick_slip_.choose_modes(0.0, y_);
  if (choose_modes_of_touching(equations_, 0.0, y_)) {
    stick_slip_.resolve_modes(0.0, y_);
  }
  projection_.project(0.0, y_);
  equations_.accept(0.0, y_);
  equations_.solve(0.0, y_);
  model_.dynamics.note_speed(y_);
  energy_.start(y_);
  change_points_.start(initial, y_);
  restart(0.0);
}

/// Lets the force elements communicate whose time has come.
void DynamicRun::communicate(double t) {
  if (equations_.forces().next_communication() > t) return;
  equations_.solve(t, y_);
  equations_.forces().communicate(t, equations_.state().loads.forces);
}

Motion DynamicRun::run() {
  start();
  instants_.sample_until(0.0);
  const double duration = model_.settings.duration;
  while (integrator_.t() < duration) {
    go_on(std::min({breaks_.after(integrator_.t()),
                    equations_.forces().next_communication(), duration}));
  }
  change_points_.finish();
  energy_.require();
  motion_.instants = std::move(instants_.instants());
  motion_.repeats = std::move(instants_.repeats());
  motion_.followed_until = instants_.followed_until();
  motion_.step_behind = instants_.step_behind();
  motion_.integration = summary();
  motion_.change_points = std::move(change_points_).among(motion_.instants);
  motion_.impacts = impacts_.impacts();
  judge_power_balance(model_.definition, motion_);
  return std::move(motion_);
}

/// One step, or its part up to the first event.
void DynamicRun::go_on(double limit) {
  if (!integrator_.step(limit)) guards_.refuse_stuck();
  guards_.require_in_time();
  const EventFinder::Event event = events_.find(integrator_);
  const double until = event.index < 0 ? integrator_.t() : event.t;
  if (peaks_) peaks_->look(integrator_, until);
  impacts_.look(integrator_, until);
  instants_.look(until);
  event.index < 0 ? end_step(limit) : pass(event);
}

void DynamicRun::end_step(double limit) {
  const double t = integrator_.t();
  instants_.sample_until(t);
  y_ = integrator_.y();
  guards_.require_closed(t, projection_.project(t, y_));
  equations_.accept(t, y_);
  model_.dynamics.note_speed(y_);
  change_points_.look(integrator_, t, y_);
  integrator_.correct(y_);
  energy_.note_step(y_);
  guards_.require_resisting_friction(y_);
  if (t == limit && limit < model_.settings.duration) pass_break(limit);
}

void DynamicRun::pass(const EventFinder::Event& event) {
  const double t = event.t;
  if (guards_.are_events_crowded(t)) refuse_crowded_events(t);
  instants_.want_sides(t);
  instants_.sample_until(t);
  instants_.state_at(t, y_);
  projection_.project(t, y_);  // what stuck rests, without round-off
  change_points_.look(integrator_, t, y_);
  equations_.solve(t, y_);
  ForceModel& forces = equations_.forces();
  const std::vector<int> before = modes(forces);
  pass_event(event.index, equations_.state().loads.forces, forces);
  stick_slip_.stop_or_reverse(t, y_, static_cast<std::size_t>(event.index / 2));
  stick_slip_.resolve_modes(t, y_);
  projection_.project(t, y_);
  equations_.accept(t, y_);
  impacts_.pass(t, y_, before);
  for (MotionEvent& change : mode_changes(forces, event.index, t, before)) {
    motion_.events.push_back(std::move(change));
  }
  restart(t);
}

/// A time at which laws of drives or tables bend, or gas communicates.
void DynamicRun::pass_break(double t) {
  communicate(t);
  equations_.enter_piece(t);
  if (breaks_.is_jump(t)) {
    projection_.jump(t, y_);
    stick_slip_.choose_modes(t, y_);
    projection_.project(t, y_);
    equations_.accept(t, y_);
  } else {
    stick_slip_.resolve_modes(t,
                              y_);  // what rests may have to yield to a drive
  }
  restart(t);
}

void DynamicRun::restart(double t) {
  events_.start(t, y_);
  if (peaks_) peaks_->restart(t, y_);
  instants_.restart(t, y_);
  change_points_.restart(y_);
  integrator_.restart(t, y_, stick_slip_.first_step(t, y_));
}

void DynamicRun::refuse_crowded_events(double t) {
  guards_.refuse_dead_end();
  instants_.state_at(t, y_);
  instants_.add(t, y_);
  refuse_open_loads(model_.definition, equations_.forces(),
                    instants_.instants().back().joints);
  guards_.refuse_crowded_events(t);
}

IntegrationSummary DynamicRun::summary() const {
  const numerics::StepCounts& counts = integrator_.counts();
  return {.method = integrator_.method(),
          .steps = counts.steps,
          .rejected = counts.rejected,
          .evaluations = counts.evaluations + instants_.evaluations(),
          .factorisations = counts.factorisations,
          .implicit_steps = integrator_.implicit_steps(),
          .energy_error = energy_.error(),
          .relative_energy_error = energy_.relative_error()};
}

}  // namespace clevis::mechanism
