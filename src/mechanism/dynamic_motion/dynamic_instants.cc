#include "mechanism/dynamic_motion/dynamic_instants.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

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

std::vector<double> all_times(const SimulationSettings& settings,
                              const std::vector<double>& others) {
  std::vector<double> times = uniform_times(settings);
  add_times(others, settings.duration, times);
  return times;
}

}  // namespace

bool BesideChangePoints::contains(double t) const {
  return std::ranges::any_of(times, [&](double point) {
    return std::abs(point - t) <= reach;
  });
}

DynamicInstants::DynamicInstants(DynamicModel& model,
                                 DynamicChangePoints& change_points,
                                 MotionIntegrator& integrator,
                                 EnergyBalance& energy, MotionGuards& guards,
                                 const std::vector<double>& others)
    : model_(model),
      change_points_(change_points),
      integrator_(integrator),
      resampler_(model.definition, model.frame, model.dynamics,
                 model.settings.integrator),
      energy_(energy),
      guards_(guards),
      times_(all_times(model.settings, others)),
      sample_(VectorXd::Zero(model.dynamics.size())) {}

void DynamicInstants::refine(const VectorXd& largest,
                             const BesideChangePoints& beside) {
  sampler_.emplace(model_.equations, largest);
  beside_ = beside;
}

void DynamicInstants::restart(double t, const VectorXd& y) {
  if (sampler_) sampler_->restart(t, y);
}

void DynamicInstants::look(double until) {
  if (!sampler_) return;
  const double duration = model_.settings.duration;
  for (auto* times : {&wanted_, &followed_}) times->clear();
  sampler_->look(integrator_, until, std::span(times_).subspan(next_), wanted_,
                 followed_);
  for (auto* times : {&wanted_, &followed_}) {
    std::erase_if(*times, [this](double t) {
      return beside_.contains(t);
    });
  }
  add_times(wanted_, duration, times_);
  std::vector<double> all(times_.begin() + static_cast<std::ptrdiff_t>(next_),
                          times_.end());
  add_times(followed_, duration, all);
  for (const double t : followed_) {
    if (!std::ranges::binary_search(times_, t) &&
        std::ranges::binary_search(all, t)) {
      repeated_.push_back(t);
    }
  }
  add_times(followed_, duration, times_);
}

double DynamicInstants::followed_until() const {
  return sampler_ ? sampler_->followed_until()
                  : std::numeric_limits<double>::infinity();
}

double DynamicInstants::step_behind() const {
  return sampler_ ? sampler_->step_behind()
                  : std::numeric_limits<double>::infinity();
}

/// That before is at the time itself where the modes change only then.
void DynamicInstants::want_sides(double t) {
  if (!sampler_) return;
  const double duration = model_.settings.duration;
  const double side = kSides * duration;
  if (t < side || t + side > duration || two_sided_++ >= kMostTwoSided) return;
  add_times({t, t + side}, duration, times_);
}

void DynamicInstants::sample_until(double t) {
  while (next_ < times_.size() && times_[next_] <= t) {
    const double at = times_[next_++];
    if (at >= integrator_.t()) {
      sample_ = integrator_.y();
    } else {
      state_at(at, sample_);
    }
    add(at, sample_);
  }
}

void DynamicInstants::add(double t, VectorXd& y) {
  const bool repeats = std::ranges::binary_search(repeated_, t);
  (repeats ? repeats_ : instants_).push_back(instant_at(t, y));
}

/// @param y  the state at t, which is projected.
Instant DynamicInstants::instant_at(double t, VectorXd& y) {
  EquationsOfMotion& equations = model_.equations;
  const double gap = model_.projection.project(t, y);
  guards_.require_closed(t, gap);
  const MotionSolution& solution = equations.solve(t, y);
  energy_.note(y);
  const ConstraintSystem& system = equations.system();
  const MechanismState& state = equations.state();
  auto accelerations = system.twists(solution.accelerations);
  numerics::JacobianFactor factor;
  factor.compute(system.jacobian(state.placed), nullptr,
                 model_.frame.rank_threshold());
  const bool is_change_point = factor.rank() < change_points_.rank();
  std::optional<Equilibrium::Solution> forces;
  if (is_change_point) {
    if (auto found = change_points_.on_branch(t, y)) {
      accelerations = std::move(found->accelerations);
      forces = std::move(found->forces);
    }
  }
  const ForceModel& elements = equations.forces();
  if (!forces) {
    std::vector<SpatialForce> applied(state.twists.size());
    elements.add_to(state.loads.forces, applied);
    const auto acting = model_.frame.links.empty()
                            ? std::vector<ElementState>{}
                            : elements.results(state.loads.forces);
    forces =
        model_.equilibrium.solve(state.x, state.placed, factor, state.twists,
                                 accelerations, applied, acting);
  }
  Instant instant = motion_at(model_.definition, model_.frame, state, elements,
                              t, accelerations);
  put_forces(model_.frame, system, state.placed, std::move(*forces), instant);
  mark_what_friction_leaves_open(model_.frame, system, state.placed, elements,
                                 state.loads.forces, instant);
  instant.is_change_point = is_change_point;
  require_unique_loads(model_.definition, elements, state.loads.forces,
                       instant.joints);
  instant.closure_error = gap;
  return instant;
}

/// Whether the dense output at t errs; y is projected.
bool DynamicInstants::is_rough(double t, VectorXd& y) {
  model_.projection.project(t, y);
  return energy_.misses(y);
}

void DynamicInstants::state_at(double t, VectorXd& y) {
  integrator_.state_at(t, y);
  if (!is_rough(t, y)) return;
  const double start = integrator_.t_start();
  integrator_.state_at(start, y);
  model_.projection.project(start, y);
  resampler_.restart(start, y, t - start);
  constexpr int kMost = 1000;  // else the motion is rough beyond help
  for (int i = 0; resampler_.t() < t; ++i) {
    if (i == kMost || !resampler_.step(t)) return integrator_.state_at(t, y);
  }
  y = resampler_.y();
}

}  // namespace clevis::mechanism
