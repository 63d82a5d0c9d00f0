#include "mechanism/forces/force_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/index.h"
#include "mechanism/drives/drive_law.h"

namespace clevis::mechanism {
namespace {

void add_wrench(Twist& sum, const Twist& wrench) {
  sum.v += wrench.v;
  sum.w += wrench.w;
}

/// Coordinate of a joint at t = 0 where the scene says it, else 0: decides
/// from which turn an angle counts.
double start_of(const ForceElement& element,
                const MechanismDefinition& definition) {
  const ElementLine* given = line_of(element);
  if (given == nullptr || given->kind != ElementLine::Kind::kJoint) return 0.0;
  const ElementLine& line = *given;
  for (const DriveDefinition& drive : definition.drives) {
    if (drive.joint == line.joint && drive.coordinate == line.coordinate) {
      return drive_target(drive, 0.0).position;
    }
  }
  for (const InitialJointState& initial : definition.initial_joints) {
    if (initial.joint == line.joint && line.coordinate == 0) {
      return initial.position.value_or(0.0);
    }
  }
  const DriveDefinition* reference = properties(element).reference;
  return reference == nullptr ? 0.0 : drive_target(*reference, 0.0).position;
}

}  // namespace

ForceModel::ForceModel(const MechanismDefinition& definition,
                       const SolvingFrame& frame)
    : definitions_(definition.elements) {
  for (const ForceElement& given : definitions_) {
    elements_.push_back(place(given, frame));
    ActingElement& e = *elements_.back();
    may_switch_ = may_switch_ || e.may_switch();
    e.q_start = start_of(given, definition);
    e.internal_rates.resize(static_cast<std::size_t>(e.internal_states()));
    if (e.internal_states() > 0) e.internal = internal_states_;
    internal_states_ += e.internal_states();
  }
}

void ForceModel::start_internal(const Configuration& x, double* internal) {
  for (const auto& e : elements_) {
    if (e->internal >= 0) e->start(x, internal + e->internal);
  }
}

void ForceModel::evaluate(double t, const Configuration& x,
                          const std::vector<Twist>& twists,
                          const double* internal) {
  t_ = t;
  const ActingState state{.t = t,
                          .configuration = x,
                          .twists = twists,
                          .internal = internal,
                          .side = t > piece_start_
                                      ? numerics::StepSide::kBefore
                                      : numerics::StepSide::kBehind};
  for (const auto& e : elements_) e->evaluate(state);
}

double ForceModel::next_communication() const {
  double next = std::numeric_limits<double>::infinity();
  for (const auto& e : elements_) {
    next = std::min(next, e->next_communication());
  }
  return next;
}

void ForceModel::communicate(double t) {
  for (const auto& e : elements_) {
    if (e->next_communication() <= t) e->communicate(t);
  }
}

void ForceModel::accept(double t) {
  for (const auto& e : elements_) e->accept(t);
}

void ForceModel::add_to(std::vector<Twist>& wrenches) const {
  for (const auto& e : elements_) {
    add_wrench(wrenches[index(e->line.a)], e->on_a);
    add_wrench(wrenches[index(e->line.b)], e->on_b);
  }
}

void ForceModel::internal_rates(double* rates) const {
  for (const auto& e : elements_) {
    rates = std::ranges::copy(e->internal_rates, rates).out;
  }
}

void ForceModel::internal_scales(const double* internal, double* scales) const {
  for (const auto& e : elements_) {
    if (e->internal < 0) continue;
    e->scales(internal + e->internal, scales + e->internal);
  }
}

void ForceModel::choose_modes() {
  for (const auto& e : elements_) e->choose_modes();
}

bool ForceModel::any_sticks() const {
  return std::ranges::any_of(elements_, [](const auto& e) {
    return e->sticks();
  });
}

void ForceModel::set_row_effort(std::size_t k, double effort) {
  ActingElement& e = *elements_[k];
  const bool turns_rotor = inertia(k) > 0.0;
  e.act_along(turns_rotor ? e.effort + effort : effort);
  if (turns_rotor) e.power = e.effort * e.rate;
}

bool ForceModel::counts_turns() const {
  return std::ranges::any_of(elements_, [](const auto& e) {
    return e->line.counts_turns;
  });
}

double ForceModel::line_bias(std::size_t k,
                             const std::vector<Twist>& twists) const {
  const ActingElement& e = *elements_[k];
  return e.placed.bias(e.row, twists[index(e.line.a)], twists[index(e.line.b)]);
}

double ForceModel::joint_rate(std::size_t k,
                              const std::vector<PlacedJoint>& placed,
                              const std::vector<Twist>& twists) const {
  const ActingElement& e = *elements_[k];
  const Eigen::Vector3d axis = placed[index(e.joint)].axes_a.col(2);
  return axis.dot(twists[index(e.line.b)].w - twists[index(e.line.a)].w);
}

double ForceModel::line_acceleration(std::size_t k,
                                     const std::vector<Twist>& accelerations,
                                     const std::vector<Twist>& twists) const {
  const ActingElement& e = *elements_[k];
  const Twist& a = accelerations[index(e.line.a)];
  const Twist& b = accelerations[index(e.line.b)];
  return e.levers.a.v.dot(a.v) + e.levers.a.w.dot(a.w) + e.levers.b.v.dot(b.v) +
         e.levers.b.w.dot(b.w) + line_bias(k, twists);
}

double ForceModel::sliding_acceleration(
    std::size_t k, const std::vector<Twist>& accelerations) const {
  const ActingElement& e = *elements_[k];
  return e.sliding_acceleration(accelerations[index(e.line.a)],
                                accelerations[index(e.line.b)]);
}

std::vector<std::size_t> ForceModel::with_smooth_efforts() const {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    if (elements_[k]->has_smooth_effort()) found.push_back(k);
  }
  return found;
}

void ForceModel::set_effort(std::size_t k, double effort) {
  ActingElement& e = *elements_[k];
  e.act_along(effort);
  e.power = e.effort * e.rate;
}

void ForceModel::set_load(std::size_t k, double load) {
  ActingElement& e = *elements_[k];
  e.load = load;
  if (sticks(k)) return;
  e.act_along(load * e.per_load + e.own_effort);
  e.power = e.effort * e.rate;
}

std::size_t ForceModel::line_against_its_mode() const {
  constexpr double kTimesSlack = 10.0;
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    const ActingElement& e = *elements_[k];
    if (!is_dry(k)) continue;
    const int mode = e.modes[0];
    if (mode == kOmitted || std::abs(mode) == 2) continue;  // an event ends it
    const double against = mode == 0 ? std::abs(e.rate) : -mode * e.rate;
    if (against > kTimesSlack * e.slack) return k;
  }
  return elements_.size();
}

void ForceModel::hold_tangents(const double* internal) {
  for (const auto& e : elements_) e->hold_tangent(internal);
}

void ForceModel::release_tangents() {
  for (const auto& e : elements_) e->release_tangent();
}

void ForceModel::set_slack(double slack, double leaving, double length,
                           double per_second) {
  for (const auto& e : elements_) {
    const double arm = e->row.is_angle() ? length : 1.0;
    e->slack = std::min(slack / arm, per_second * e->bristle_deflection());
    e->leaving = leaving / arm;
  }
}

void ForceModel::event_values(Eigen::VectorXd& values) const {
  for (int i = 0; i < events(); ++i) {
    values[i] = elements_[index(i / 2)]->event_value(i % 2);
  }
}

void ForceModel::pass_event(int event) {
  elements_[index(event / 2)]->pass_event(event % 2);
}

std::vector<int> ForceModel::modes() const {
  std::vector<int> modes;
  for (const auto& e : elements_) {
    modes.insert(modes.end(), e->modes.begin(), e->modes.end());
  }
  return modes;
}

std::vector<MotionEvent> ForceModel::changes(
    int event, double t, const std::vector<int>& before) const {
  std::vector<MotionEvent> changes;
  for (int i = 0; i < events(); ++i) {
    const auto k = index(i / 2);
    if (i != event && !is_dry(k)) continue;
    const char* what = elements_[k]->name_of_change(i % 2, before[index(i)]);
    if (what != nullptr) changes.push_back({t, i / 2, what});
  }
  return changes;
}

std::vector<double> ForceModel::breakpoint_times() const {
  std::vector<double> times;
  for (const ForceElement& element : definitions_) {
    const std::vector<double> more = properties(element).breaks;
    times.insert(times.end(), more.begin(), more.end());
  }
  return times;
}

std::vector<ElementState> ForceModel::states() const {
  std::vector<ElementState> states;
  for (const auto& e : elements_) {
    states.push_back({.position = e->q,
                      .rate = e->rate,
                      .effort = e->effort,
                      .friction = e->friction,
                      .power = e->power,
                      .actions = e->actions()});
    e->report(t_, states.back());
  }
  return states;
}

}  // namespace clevis::mechanism
