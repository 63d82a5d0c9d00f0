#include "mechanism/events/impact_recorder.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/values/index.h"
#include "mechanism/forces/element_modes.h"

namespace clevis::mechanism {
namespace {

// Lobatto's five nodes of [0, 1] and weights, exact to degree 7.
const double kInner = 0.5 * (1.0 - std::sqrt(3.0 / 7.0));
const std::array<double, 5> kNodes{0.0, kInner, 0.5, 1.0 - kInner, 1.0};
constexpr std::array<double, 5> kWeights{1.0 / 20.0, 49.0 / 180.0, 16.0 / 45.0,
                                         49.0 / 180.0, 1.0 / 20.0};

constexpr int kPressing = 1;

}  // namespace

ImpactRecorder::ImpactRecorder(EquationsOfMotion& equations)
    : equations_(equations),
      open_(index(event_count(equations.forces())), -1),
      last_(open_) {
  state_.setZero(equations.layout().size());
}

Impact* ImpactRecorder::open_impact(int event) {
  const int which = open_[index(event)];
  return which < 0 ? nullptr : &impacts_[index(which)];
}

double ImpactRecorder::effort(const Impact& impact,
                              numerics::Integrator& integrator, double t) {
  integrator.interpolate(t, state_);
  const MechanismState& state = equations_.evaluate_forces(t, state_);
  return state.loads.forces.elements[index(impact.element)]
      .unbounded[index(impact.end)];
}

void ImpactRecorder::look(numerics::Integrator& integrator, double until) {
  const double from = integrator.t_start(), step = until - from;
  for (std::size_t event = 0; event < open_.size(); ++event) {
    Impact* impact = open_impact(static_cast<int>(event));
    if (impact == nullptr || !(step > 0.0)) continue;
    std::array<double, 5> values{};
    for (std::size_t i = 0; i < kNodes.size(); ++i) {
      values[i] = effort(*impact, integrator, from + step * kNodes[i]);
      impact->impulse += kWeights[i] * step * values[i];
    }
    const auto top = static_cast<std::size_t>(std::ranges::max_element(values) -
                                              values.begin());
    if (values[top] < 0.98 * impact->peak_force) continue;
    const std::size_t low = top == 0 ? 0 : top - 1;
    const std::size_t high = std::min(top + 1, kNodes.size() - 1);
    refine(*impact, integrator, from + step * kNodes[low],
           from + step * kNodes[high]);
  }
}

void ImpactRecorder::refine(Impact& impact, numerics::Integrator& integrator,
                            double from, double to) {
  constexpr int kSections = 20;
  constexpr double kGolden = 0.6180339887498949;
  for (int i = 0; i < kSections; ++i) {
    const double left = to - kGolden * (to - from);
    const double right = from + kGolden * (to - from);
    const double at_left = effort(impact, integrator, left);
    const double at_right = effort(impact, integrator, right);
    if (std::max(at_left, at_right) > impact.peak_force) {
      impact.peak_force = std::max(at_left, at_right);
      impact.peak_at = at_left > at_right ? left : right;
    }
    (at_left > at_right ? to : from) = at_left > at_right ? right : left;
  }
}

void ImpactRecorder::begin(int event, double t) {
  const std::size_t element = index(event / 2), end = index(event % 2);
  Impact impact;
  impact.element = event / 2;
  impact.end = event % 2;
  impact.t = impact.peak_at = t;
  impact.approach_speed =
      equations_.state().loads.forces.elements[element].depth_rate[end];
  const ContactInertia inertia =
      contact_inertia(equations_, element, event % 2);
  impact.mass_a = inertia.mass_a;
  impact.mass_b = inertia.mass_b;
  impact.mass = inertia.mass;
  impact.force = inertia.force;
  open_[index(event)] = last_[index(event)] = static_cast<int>(impacts_.size());
  impacts_.push_back(impact);
}

void ImpactRecorder::pass(double t, const Eigen::VectorXd& y,
                          const std::vector<int>& before) {
  const std::vector<int> now = modes(equations_.forces());
  bool evaluated = false;
  for (std::size_t event = 0; event < now.size(); ++event) {
    if (!equations_.forces().element(event / 2).presses(
            static_cast<int>(event % 2))) {
      continue;
    }
    const bool pressed = before[event] == kPressing;
    const bool presses = now[event] == kPressing;
    if (pressed == presses) continue;
    if (!presses) {
      if (Impact* impact = open_impact(static_cast<int>(event))) {
        impact->duration = t - impact->t;
        const ForceState& acting = equations_.state().loads.forces;
        impact->exit_speed = -acting.elements[event / 2].depth_rate[event % 2];
      }
      open_[event] = -1;
    } else if (before[event] == 0 || last_[event] < 0) {
      if (!evaluated) equations_.solve(t, y);
      evaluated = true;
      begin(static_cast<int>(event), t);
    } else {  // deep without force in between: the same impact goes on
      open_[event] = last_[event];
      impacts_[index(last_[event])].duration.reset();
    }
  }
}

}  // namespace clevis::mechanism
