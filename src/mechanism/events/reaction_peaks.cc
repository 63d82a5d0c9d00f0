#include "mechanism/events/reaction_peaks.h"

#include <algorithm>
#include <cmath>

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::VectorXd;

ReactionPeaks::ReactionPeaks(EquationsOfMotion& equations)
    : equations_(equations),
      list_(equations.system(), equations.state().x, equations.forces()) {
  for (VectorXd* v : {&before_.values, &last_.values, &next_.values, &largest_,
                      &at_, &values_}) {
    v->setZero(list_.vectors());
  }
  loads_.setZero(list_.size());
  state_.setZero(equations.layout().size());
}

/// Squares by vector.
void ReactionPeaks::measure(double t, const VectorXd& y, VectorXd& values) {
  const MotionSolution& solution = equations_.solve(t, y);
  list_.get(equations_.system(), solution.multipliers,
            equations_.state().loads.forces, loads_);
  list_.squares(loads_, values);
}

void ReactionPeaks::note(const Sample& sample) {
  for (Index k = 0; k < largest_.size(); ++k) {
    if (sample.values[k] <= largest_[k]) continue;
    largest_[k] = sample.values[k];
    at_[k] = sample.t;
  }
}

void ReactionPeaks::restart(double t, const VectorXd& y) {
  last_.t = t;
  measure(t, y, last_.values);
  note(last_);
  has_before_ = false;
}

void ReactionPeaks::look(numerics::Integrator& integrator, double until) {
  // close to both ends, so that three samples of one step hold a maximum
  constexpr double kFlat = 1e-6;
  constexpr double kParts[] = {0.001, 0.25, 0.5, 0.75, 0.999, 1.0};
  const double start = integrator.t_start();
  for (const double part : kParts) {
    next_.t = part == 1.0 ? until : start + part * (until - start);
    integrator.interpolate(next_.t, state_);
    measure(next_.t, state_, next_.values);
    for (Index i = 0; has_before_ && i < largest_.size(); ++i) {
      const double middle = last_.values[i];
      const double fall = middle - std::min(before_.values[i], next_.values[i]);
      // at rest nothing falls, and nothing is missed
      if (middle < before_.values[i] || middle < next_.values[i] ||
          fall <= kFlat * largest_[i] || !may_exceed(i)) {
        continue;
      }
      refine(integrator, i, std::max(before_.t, start), next_.t);
    }
    note(next_);
    std::swap(before_, last_);
    std::swap(last_, next_);
    has_before_ = true;
  }
}

/// Whether a maximum about the middle one of three samples may be the largest
/// so far: by three times what the parabola through them rises above it.
bool ReactionPeaks::may_exceed(Index i) const {
  constexpr double kSafety = 3.0;
  const double left = last_.t - before_.t, right = next_.t - last_.t;
  const double middle = last_.values[i];
  const double a = (before_.values[i] - middle) / left;
  const double b = (next_.values[i] - middle) / right;
  // middle + slope s + curvature s²
  const double curvature = (a + b) / (left + right);
  const double slope = b - curvature * right;
  if (!(curvature < 0.0)) return true;
  const double rise = -0.25 * slope * slope / curvature;
  return middle + kSafety * rise > largest_[i];
}

void ReactionPeaks::refine(numerics::Integrator& integrator, Index which,
                           double from, double to) {
  constexpr int kSections = 16;
  constexpr double kGolden = 0.6180339887498949;
  const auto value = [&](double t) {
    integrator.interpolate(t, state_);
    measure(t, state_, values_);
    return values_[which];
  };
  double left = to - kGolden * (to - from);
  double right = from + kGolden * (to - from);
  double at_left = value(left), at_right = value(right);
  for (int i = 0; i < kSections; ++i) {
    if (at_left > at_right) {
      to = right;
      right = left;
      at_right = at_left;
      left = to - kGolden * (to - from);
      at_left = value(left);
    } else {
      from = left;
      left = right;
      at_left = at_right;
      right = from + kGolden * (to - from);
      at_right = value(right);
    }
  }
  if (std::max(at_left, at_right) <= largest_[which]) return;
  largest_[which] = std::max(at_left, at_right);
  at_[which] = at_left > at_right ? left : right;
}

std::vector<double> ReactionPeaks::times() const {
  std::vector<double> times;
  for (Index k = 0; k < at_.size(); ++k) {
    if (largest_[k] > 0.0) times.push_back(at_[k]);
  }
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace clevis::mechanism
