#include "mechanism/dynamic_motion.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/errors.h"
#include "mechanism/body_motion.h"
#include "mechanism/drive_law.h"
#include "mechanism/driven_sampling.h"
#include "mechanism/dynamic_change_points.h"
#include "mechanism/equilibrium.h"
#include "mechanism/event_finder.h"
#include "mechanism/forward_dynamics.h"
#include "mechanism/held_lines.h"
#include "mechanism/impact_watch.h"
#include "mechanism/initial_state.h"
#include "mechanism/load_sampler.h"
#include "mechanism/power_balance.h"
#include "mechanism/reaction_peaks.h"
#include "mechanism/switching_integrator.h"

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Local errors add up over a motion; steps are this much stricter, down to
// round-off, and of closed loops to where that governs beside change points.
constexpr double kLocalPart = 0.01;
constexpr double kStrictest = 1e-14, kStrictestOfLoops = 1e-11;

double step_tolerance(const MechanismDefinition& definition, double tolerance) {
  const bool loops = definition.joints.size() > definition.bodies.size();
  return std::max(kLocalPart * tolerance,
                  loops ? kStrictestOfLoops : kStrictest);
}

// Instants on both sides of more events than this would only crowd.
constexpr int kMostTwoSided = 1000;

std::vector<double> sample_times(const SimulationSettings& settings,
                                 const std::vector<double>& others) {
  std::vector<double> times = uniform_times(settings);
  add_times(others, settings.duration, times);
  return times;
}

/// One run: integrates and samples.
class DynamicRun {
 public:
  /// @param others  instants besides the uniform ones.
  DynamicRun(const MechanismDefinition& definition,
             const SimulationSettings& settings,
             const std::vector<double>& others = {})
      : definition_(definition),
        settings_(settings),
        frame_(frame_at_centres(definition)),
        dynamics_(definition, frame_,
                  step_tolerance(definition, settings.tolerance),
                  settings.duration),
        equilibrium_(definition, frame_, dynamics_.system()),
        change_points_(definition, settings, frame_, dynamics_, equilibrium_),
        integrator_(dynamics_, settings.integrator),
        events_(dynamics_),
        impacts_(dynamics_),
        sample_times_(sample_times(settings, others)) {}

  Motion run();
  /// Lets the run look for the largest reactions.
  void watch() { peaks_.emplace(dynamics_); }
  const ReactionPeaks& peaks() const { return *peaks_; }
  /// Lets the run add instants so that large loads change little between
  /// them, and on both sides of events.
  /// @param largest  as ReactionPeaks found them.
  void refine(const VectorXd& largest) { sampler_.emplace(dynamics_, largest); }

 private:
  void start();
  void find_breaks();
  double next_break() const;
  void pass(const EventFinder::Event& event);
  void pass_bend(double t);
  void restart(double t);
  void guard_against_accumulation(double t);
  void require_few(const StepCounts& counts) const;
  void sample_until(double t);
  void add_wanted(double until);
  void want_sides(double t);
  void add_instant(double t, VectorXd& y);
  void note_energy(const VectorXd& y);
  void require_energy_balance() const;
  void require_resisting_friction();

  const MechanismDefinition& definition_;
  const SimulationSettings& settings_;
  SolvingFrame frame_;
  ForwardDynamics dynamics_;
  Equilibrium equilibrium_;
  DynamicChangePoints change_points_;
  SwitchingIntegrator integrator_;
  EventFinder events_;
  ImpactWatch impacts_;
  std::vector<double> sample_times_;
  VectorXd y_, sample_, slope_;
  std::size_t next_sample_ = 0;
  std::optional<ReactionPeaks> peaks_;
  std::optional<LoadSampler> sampler_;
  std::vector<double> wanted_;
  int two_sided_ = 0;
  VectorXd event_values_;
  std::vector<DriveJump> jumps_;
  std::vector<double> breaks_;  ///< times at which drives or tables bend
  int crowded_events_ = 0;
  double last_event_ = -1.0;
  double energy_start_{}, energy_error_{}, largest_energy_{};
  double largest_load_{};  ///< force on a body [N]
  Motion motion_;
};

void DynamicRun::start() {
  const InitialState initial =
      initial_state(definition_, frame_, dynamics_.system(),
                    settings_.tolerance * frame_.length);
  y_ = dynamics_.start(initial.x);
  y_.segment(dynamics_.velocity_index(), initial.velocities.size()) =
      initial.velocities;
  event_values_.setOnes(dynamics_.forces().events());
  find_breaks();
  dynamics_.project(0.0, y_);
  dynamics_.communicate(0.0, y_);
  dynamics_.choose_modes(0.0, y_);
  dynamics_.project(0.0, y_);
  dynamics_.accept(0.0);
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
  jumps_ = drive_jumps(definition_, settings_.duration);
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

void DynamicRun::guard_against_accumulation(double t) {
  constexpr int kMost = 200;
  const double crowd = 1e-9 * settings_.duration;
  crowded_events_ = t - last_event_ < crowd ? crowded_events_ + 1 : 0;
  last_event_ = t;
  if (crowded_events_ < kMost) return;
  throw Error("K008", "mechanism",
              fmt::format("at t = {:.9g} s events of contact or friction "
                          "follow one another without end",
                          t),
              "give the contact damping, or the friction model = "
              "\"regularized\"");
}

/// Instants that the loads of the last step call for.
void DynamicRun::add_wanted(double until) {
  wanted_.clear();
  sampler_->look(integrator_, until,
                 std::span(sample_times_).subspan(next_sample_), wanted_);
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

void DynamicRun::pass(const EventFinder::Event& event) {
  const double t = event.t;
  guard_against_accumulation(t);
  if (sampler_) want_sides(t);
  sample_until(t);
  integrator_.state_at(t, y_);
  dynamics_.project(t, y_);  // what stuck rests, without round-off
  dynamics_.event_values(t, y_, event_values_);
  ForceModel& forces = dynamics_.forces();
  const std::vector<int> before = forces.modes();
  forces.pass_event(event.index);
  dynamics_.rest_or_turn(t, y_, static_cast<std::size_t>(event.index / 2));
  dynamics_.settle(t, y_);
  dynamics_.project(t, y_);
  dynamics_.accept(t);
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
  }
  restart(t);
}

void DynamicRun::restart(double t) {
  events_.start(t, y_);
  if (peaks_) peaks_->restart(t, y_);
  if (sampler_) sampler_->restart(t, y_);
  integrator_.restart(t, y_, 0.0);
}

void DynamicRun::note_energy(const VectorXd& y) {
  const double kinetic = dynamics_.kinetic_energy(y);
  const double work = y[dynamics_.work_index()];
  energy_error_ =
      std::max(energy_error_, std::abs(kinetic - energy_start_ - work));
  largest_energy_ = std::max({largest_energy_, kinetic, std::abs(work)});
  largest_load_ = std::max(largest_load_, dynamics_.largest_load());
}

/// Kinetic energy and work must agree: to a part of the largest of them, or to
/// what the largest force does over the error of positions that is allowed.
void DynamicRun::require_energy_balance() const {
  constexpr double kPart = 0.01, kTimesAllowed = 100.0;
  const double allowed =
      std::max(kPart, kTimesAllowed * settings_.tolerance) * largest_energy_ +
      kTimesAllowed * settings_.tolerance * frame_.length * largest_load_;
  if (energy_error_ <= allowed) return;
  throw Error("K012", "mechanism",
              fmt::format("kinetic energy and the work of all forces differ by "
                          "{:.3g} J, {:.2g} of the largest: the integration "
                          "failed",
                          energy_error_, energy_error_ / largest_energy_),
              "ask for a stricter tolerance, and look for lengths, masses or "
              "forces of a wrong order of size");
}

/// Friction at rest holds, friction that slips resists.
void DynamicRun::require_resisting_friction() {
  if (dynamics_.forces().empty()) return;
  dynamics_.evaluate_forces(integrator_.t(), y_);
  const std::size_t k = dynamics_.forces().line_against_its_mode();
  if (k == dynamics_.forces().size()) return;
  throw Error("K012", std::get<LineElement>(definition_.elements[k]).place,
              fmt::format("at t = {:.9g} s friction {} moves its line instead "
                          "of resisting: the integration failed",
                          integrator_.t(), name_of(definition_.elements[k])),
              "ask for a stricter tolerance, or give the friction model = "
              "\"regularized\"");
}

void DynamicRun::add_instant(double t, VectorXd& y) {
  const double gap = dynamics_.project(t, y);
  dynamics_.rate(t, y, slope_);
  note_energy(y);
  const ConstraintSystem& system = dynamics_.system();
  const auto placed = system.place(dynamics_.configuration());
  auto accelerations = system.twists(dynamics_.accelerations());
  JacobianFactor factor;
  factor.compute(system.jacobian(placed));
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

void DynamicRun::sample_until(double t) {
  while (next_sample_ < sample_times_.size() &&
         sample_times_[next_sample_] <= t) {
    const double at = sample_times_[next_sample_++];
    if (at >= integrator_.t()) {
      sample_ = integrator_.y();
    } else {
      integrator_.state_at(at, sample_);
    }
    add_instant(at, sample_);
  }
}

/// A motion that would take hours is refused with what it is stuck at.
void DynamicRun::require_few(const StepCounts& counts) const {
  constexpr long kMost = 20'000'000;
  if (counts.evaluations < kMost) return;
  throw Error(
      "K008", "mechanism",
      fmt::format("{} evaluations in {} steps by {} have only reached "
                  "t = {:.9g} s of {:.9g} s",
                  counts.evaluations, counts.steps, integrator_.method(),
                  integrator_.t(), settings_.duration),
      "ask for a shorter motion or a looser tolerance, soften what is "
      "stiff, or try another `integrator`");
}

Motion DynamicRun::run() {
  start();
  sample_until(0.0);
  while (integrator_.t() < settings_.duration) {
    const double limit = next_break();
    if (!integrator_.step(limit)) {
      if (dynamics_.jams()) refuse_jam(integrator_.t());
      throw Error("K008", "mechanism",
                  fmt::format("at t = {:.9g} s no step is short enough",
                              integrator_.t()),
                  "look for forces or lengths of a wrong order of size");
    }
    require_few(integrator_.counts());
    const EventFinder::Event event = events_.find(integrator_);
    if (peaks_) {
      peaks_->look(integrator_, event.index < 0 ? integrator_.t() : event.t);
    }
    change_points_.look(integrator_,
                        event.index < 0 ? integrator_.t() : event.t);
    impacts_.look(integrator_, event.index < 0 ? integrator_.t() : event.t);
    if (sampler_) add_wanted(event.index < 0 ? integrator_.t() : event.t);
    if (event.index >= 0) {
      pass(event);
      continue;
    }
    sample_until(integrator_.t());
    y_ = integrator_.y();
    dynamics_.project(integrator_.t(), y_);
    dynamics_.accept(integrator_.t());
    dynamics_.note_speed(y_);
    integrator_.correct(y_);
    note_energy(y_);
    require_resisting_friction();
    if (integrator_.t() == limit && limit < settings_.duration) {
      pass_bend(limit);
    }
  }
  require_energy_balance();
  const StepCounts& counts = integrator_.counts();
  motion_.integration = IntegrationSummary{
      .method = integrator_.method(),
      .steps = counts.steps,
      .rejected = counts.rejected,
      .evaluations = counts.evaluations,
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

/// @throws Error K006 if a body is so light beside another that accelerations
///   by it have no digit left.
void refuse_massless(const MechanismDefinition& definition) {
  constexpr double kLightest = 1e-12;
  double heaviest = 0.0;
  for (const BodyDefinition& body : definition.bodies) {
    heaviest = std::max(heaviest, body.mass_properties.mass);
  }
  for (const BodyDefinition& body : definition.bodies) {
    const double mass = body.mass_properties.mass;
    if (mass >= kLightest * heaviest) continue;
    throw Error("K006", body.place,
                fmt::format("body {} has {:.3g} kg beside one of {:.3g} kg: "
                            "massless, for double precision",
                            body.name, mass, heaviest),
                "give the body its mass, or replace a link between two joints "
                "by a joint of type \"distance\"");
  }
}

}  // namespace

Motion integrate_motion(const MechanismDefinition& definition,
                        const SimulationSettings& settings) {
  refuse_massless(definition);
  if (!settings.at_peaks) return DynamicRun(definition, settings).run();
  // the same run twice: the first tells when loads are largest
  DynamicRun first(definition, settings);
  first.watch();
  first.run();
  std::vector<double> others = first.peaks().times();
  const std::vector<double> bends =
      sides_of_bends(definition, settings.duration);
  others.insert(others.end(), bends.begin(), bends.end());
  DynamicRun second(definition, settings, others);
  second.refine(first.peaks().largest());
  return second.run();
}

}  // namespace clevis::mechanism
