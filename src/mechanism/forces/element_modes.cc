#include "mechanism/forces/element_modes.h"

#include <cmath>

#include "base/values/index.h"
#include "mechanism/line_elements/friction.h"

namespace clevis::mechanism {

bool may_switch(const ForceModel& forces) {
  for (std::size_t k = 0; k < forces.size(); ++k) {
    if (forces.element(k).may_switch()) return true;
  }
  return false;
}

bool any_sticks(const ForceModel& forces) {
  for (std::size_t k = 0; k < forces.size(); ++k) {
    if (forces.element(k).sticks()) return true;
  }
  return false;
}

int event_count(const ForceModel& forces) {
  return static_cast<int>(2 * forces.size());
}

std::vector<int> modes(const ForceModel& forces) {
  std::vector<int> modes;
  for (std::size_t k = 0; k < forces.size(); ++k) {
    const auto& own = forces.element(k).modes;
    modes.insert(modes.end(), own.begin(), own.end());
  }
  return modes;
}

void put_event_values(const ForceModel& forces, const ForceState& state,
                      Eigen::VectorXd& values) {
  for (int i = 0; i < event_count(forces); ++i) {
    const std::size_t k = index(i / 2);
    values[i] = forces.element(k).event_value(i % 2, state.elements[k]);
  }
}

void choose_modes(const ForceState& state, ForceModel& forces) {
  for (std::size_t k = 0; k < forces.size(); ++k) {
    forces.element(k).choose_modes(state.elements[k]);
  }
}

void pass_event(int event, const ForceState& state, ForceModel& forces) {
  const std::size_t k = index(event / 2);
  forces.element(k).pass_event(event % 2, state.elements[k]);
}

std::vector<MotionEvent> mode_changes(const ForceModel& forces, int event,
                                      double t,
                                      const std::vector<int>& before) {
  std::vector<MotionEvent> changes;
  for (int i = 0; i < event_count(forces); ++i) {
    const ActingElement& e = forces.element(index(i / 2));
    if (i != event && !e.is_dry()) continue;
    const char* what = e.name_of_change(i % 2, before[index(i)]);
    if (what != nullptr) changes.push_back({t, i / 2, what});
  }
  return changes;
}

std::size_t line_against_its_mode(const ForceModel& forces,
                                  const ForceState& state) {
  constexpr double kTimesTolerance = 10.0;
  for (std::size_t k = 0; k < forces.size(); ++k) {
    const ActingElement& e = forces.element(k);
    if (!e.is_dry()) continue;
    const int mode = e.modes[0];
    if (mode == kOmitted || std::abs(mode) == 2) continue;  // an event ends it
    const double rate = state.elements[k].rate;
    const double against = mode == 0 ? std::abs(rate) : -mode * rate;
    if (against > kTimesTolerance * e.velocity_tolerance) return k;
  }
  return forces.size();
}

}  // namespace clevis::mechanism
