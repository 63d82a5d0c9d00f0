#include "mechanism/forces/force_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/values/index.h"
#include "mechanism/drives/drive_law.h"

namespace clevis::mechanism {
namespace {

void add_wrench(Twist& sum, const SpatialForce& wrench) {
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
    e.anchor.q = start_of(given, definition);
    if (e.internal_states() > 0) e.internal = internal_states_;
    internal_states_ += e.internal_states();
  }
}

void ForceModel::start_internal(const Configuration& x, double* internal) {
  for (const auto& e : elements_) {
    if (e->internal >= 0) e->start(x, internal + e->internal);
  }
}

ForceState ForceModel::none() const {
  ForceState state;
  state.elements.resize(elements_.size());
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    state.elements[k].internal_rates.resize(
        index(elements_[k]->internal_states()));
  }
  return state;
}

void ForceModel::evaluate(double t, const Configuration& x,
                          const std::vector<Twist>& twists,
                          const double* internal, ForceState& state) const {
  const ActingState at{.t = t,
                       .configuration = x,
                       .twists = twists,
                       .internal = internal,
                       .side = t > piece_start_ ? numerics::StepSide::kBefore
                                                : numerics::StepSide::kBehind};
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    elements_[k]->evaluate(at, state.elements[k]);
  }
}

void ForceModel::add_to(const ForceState& state,
                        std::vector<SpatialForce>& wrenches) const {
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    const JointModel& line = elements_[k]->line;
    add_wrench(wrenches[index(line.a)], state.elements[k].on_a);
    add_wrench(wrenches[index(line.b)], state.elements[k].on_b);
  }
}

std::vector<ElementState> ForceModel::results(const ForceState& state) const {
  std::vector<ElementState> results;
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    const ElementResponse& e = state.elements[k];
    results.push_back({.position = e.q,
                       .rate = e.rate,
                       .effort = e.effort,
                       .friction = e.friction,
                       .power = e.power,
                       .actions = elements_[k]->actions(e),
                       .channels = e.channels,
                       .chambers = e.chambers,
                       .interface = e.interface,
                       .motor = e.motor});
  }
  return results;
}

double ForceModel::next_communication() const {
  double next = std::numeric_limits<double>::infinity();
  for (const auto& e : elements_) {
    next = std::min(next, e->next_communication());
  }
  return next;
}

void ForceModel::communicate(double t, const ForceState& state) {
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    if (elements_[k]->next_communication() > t) continue;
    elements_[k]->communicate(t, state.elements[k]);
  }
}

void ForceModel::accept(double t, const ForceState& state) {
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    elements_[k]->accept(t, state.elements[k]);
  }
}

void ForceModel::internal_scales(const double* internal, double* scales) const {
  for (const auto& e : elements_) {
    if (e->internal < 0) continue;
    e->scales(internal + e->internal, scales + e->internal);
  }
}

void ForceModel::hold_tangents(const ForceState& state,
                               const double* internal) {
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    elements_[k]->hold_tangent(state.elements[k], internal);
  }
}

void ForceModel::release_tangents() {
  for (const auto& e : elements_) e->release_tangent();
}

void ForceModel::set_velocity_tolerance(double velocity_tolerance,
                                        double break_free_speed, double length,
                                        double per_second) {
  for (const auto& e : elements_) {
    const double arm = e->row.is_angle() ? length : 1.0;
    e->velocity_tolerance = std::min(velocity_tolerance / arm,
                                     per_second * e->bristle_deflection());
    e->break_free_speed = break_free_speed / arm;
  }
}

std::vector<double> ForceModel::breakpoint_times() const {
  std::vector<double> times;
  for (const ForceElement& element : definitions_) {
    const std::vector<double> more = properties(element).breaks;
    times.insert(times.end(), more.begin(), more.end());
  }
  return times;
}

}  // namespace clevis::mechanism
