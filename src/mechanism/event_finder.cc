#include "mechanism/event_finder.h"

#include "mechanism/brent.h"

namespace clevis::mechanism {

EventFinder::EventFinder(ForwardDynamics& dynamics) : dynamics_(dynamics) {
  values_.setOnes(dynamics.forces().events());
  next_ = all_ = values_;
  state_.setZero(dynamics.size());
}

void EventFinder::start(double t, const Eigen::VectorXd& y) {
  if (dynamics_.forces().may_switch()) dynamics_.event_values(t, y, values_);
}

double EventFinder::value(Integrator& integrator, int event, double t) {
  integrator.state_at(t, state_);
  dynamics_.event_values(t, state_, all_);
  return all_[event];
}

/// First zero between two times, the function negative at the later one.
double EventFinder::root(Integrator& integrator, int event, double left,
                         double at_left, double right) {
  constexpr double kBeside = 1e-3;
  // a piece that has just begun starts at zero: look beside it
  double from = left;
  if (!(at_left > 0.0)) {
    from = left + kBeside * (right - left);
    at_left = value(integrator, event, from);
  }
  if (!(at_left > 0.0)) return left;
  const double at_right = value(integrator, event, right);
  if (at_right > 0.0) return right;
  return brent_root(
      [&](double t) {
        return value(integrator, event, t);
      },
      from, at_left, right, at_right);
}

EventFinder::Event EventFinder::find(Integrator& integrator) {
  constexpr int kSamples = 4;
  Event first;
  if (!dynamics_.forces().may_switch()) return first;
  const double start = integrator.t_start(), end = integrator.t();
  double before = start;
  for (int k = 1; k <= kSamples; ++k) {
    const double at =
        k == kSamples ? end : start + (end - start) * k / kSamples;
    integrator.interpolate(at, state_);
    dynamics_.event_values(at, state_, next_);
    for (int i = 0; i < values_.size(); ++i) {
      if (!(next_[i] < 0.0) || (!(values_[i] > 0.0) && k > 1)) continue;
      const double t = root(integrator, i, before, values_[i], at);
      if (first.index < 0 || t < first.t) first = {i, t};
    }
    if (first.index >= 0) return first;
    values_ = next_;
    before = at;
  }
  return first;
}

}  // namespace clevis::mechanism
