#include "mechanism/events/event_finder.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "mechanism/forces/element_modes.h"
#include "numerics/curves/brent.h"
#include "numerics/curves/dip.h"

namespace clevis::mechanism {
namespace {

using Eigen::VectorXd;

constexpr double kLook = 0.125;  // of a sine's period

/// Time over which no law that is a sine turns back unseen [s].
double longest_look(const MechanismDefinition& definition) {
  double look = std::numeric_limits<double>::infinity();
  const auto mind = [&look](const DriveDefinition& drive) {
    if (drive.law != DriveLaw::kSine || drive.amplitude == 0.0) return;
    look = std::min(look, kLook / std::abs(drive.frequency));
  };
  for (const DriveDefinition& drive : definition.drives) mind(drive);
  for (const ForceElement& element : definition.elements) {
    const DriveDefinition* reference = properties(element).reference;
    if (reference != nullptr) mind(*reference);
  }
  return look;
}

}  // namespace

EventFinder::EventFinder(EquationsOfMotion& equations,
                         const MechanismDefinition& definition)
    : equations_(equations), longest_look_(longest_look(definition)) {
  all_.setOnes(event_count(equations.forces()));
  floors_ = all_;
  for (Sample& sample : samples_) sample.values = all_;
  for (Sample& sample : middles_) sample.values = all_;
  for (VectorXd& bend : bends_) bend = all_;
  state_.setZero(equations.layout().size());
}

void EventFinder::start(double t, const VectorXd& y) {
  if (!may_switch(equations_.forces())) return;
  measure(t, y, samples_.back().values);
}

/// Accelerations count only where efforts hold lines.
void EventFinder::measure(double t, const VectorXd& y, VectorXd& values) {
  if (any_sticks(equations_.forces())) {
    equations_.solve(t, y);
  } else {
    equations_.evaluate_forces(t, y);
  }
  put_event_values(equations_.forces(), equations_.state().loads.forces,
                   values);
}

void EventFinder::look(numerics::Integrator& integrator, double t,
                       bool carefully, VectorXd& values) {
  if (carefully) {
    integrator.state_at(t, state_);
  } else {
    integrator.interpolate(t, state_);
  }
  measure(t, state_, values);
}

double EventFinder::value(numerics::Integrator& integrator, int event,
                          double t) {
  look(integrator, t, true, all_);
  return all_[event];
}

/// First zero behind a sample, the function negative at the right end.
double EventFinder::root(numerics::Integrator& integrator, int event,
                         const Sample& left, double right) {
  constexpr double kBeside = 1e-3;
  // a piece that has just begun starts at zero: look beside it
  double from = left.t, at_from = left.values[event];
  if (!(at_from > 0.0)) {
    from = left.t + kBeside * (right - left.t);
    at_from = value(integrator, event, from);
  }
  if (!(at_from > 0.0)) return left.t;
  const double at_right = value(integrator, event, right);
  if (at_right > 0.0) return right;
  return numerics::brent_root(
      [&](double t) {
        return value(integrator, event, t);
      },
      from, at_from, right, at_right);
}

/// Windows of a step. A resting part follows time alone: no step tells how
/// fast.
/// @throws Error K008 where that is too much to look at.
long EventFinder::windows(double start, double end) {
  if (!any_sticks(equations_.forces())) return 1;
  constexpr double kMost = 5e6;  // of a motion, of half a period each
  const double count =
      std::max(std::ceil((end - start) / (kPieces * longest_look_)), 1.0);
  windows_at_rest_ += count;
  if (windows_at_rest_ <= kMost) return static_cast<long>(count);
  throw Error("K008", "mechanism",
              fmt::format("while something rests from t = {:.6g} s to {:.6g} "
                          "s, the sine of a drive or servo turns back {:.3g} "
                          "times, of {:.3g} that are looked at in a motion",
                          start, end, count, kMost),
              "Ask for a shorter motion, or correct the frequency.");
}

EventFinder::Event EventFinder::find(numerics::Integrator& integrator) {
  constexpr int kMostLooks = 400;
  if (!may_switch(equations_.forces())) return {};
  const double start = integrator.t_start(), end = integrator.t();
  const long count = windows(start, end) * kPieces;
  samples_.back().t = start;
  for (long piece = 0; piece < count; piece += kPieces) {
    looks_left_ = kMostLooks;
    std::swap(samples_.front(), samples_.back());
    for (int k = 1; k <= kPieces; ++k) {
      Sample& sample = samples_[static_cast<std::size_t>(k)];
      const double part =
          static_cast<double>(piece + k) / static_cast<double>(count);
      sample.t = piece + k == count ? end : start + (end - start) * part;
      look(integrator, sample.t, false, sample.values);
    }
    const Event event = find_in_window(integrator);
    if (event.index >= 0) return event;
  }
  return {};
}

EventFinder::Event EventFinder::find_in_window(
    numerics::Integrator& integrator) {
  measure_bends();
  for (std::size_t k = 0; k < kPieces; ++k) {
    const Event event =
        find_between(integrator, samples_[k], samples_[k + 1], 0);
    if (event.index >= 0) return event;
  }
  return {};
}

/// Bends of the pieces of a window, of the largest of its second differences
/// with a margin; floors that dips must exceed to count.
void EventFinder::measure_bends() {
  constexpr double kMargin = 4.0, kRoundOff = 1e-13, kPart = 1e-9;
  VectorXd& bend = bends_.front();
  bend.setZero();
  floors_ = samples_.front().values.cwiseAbs();
  for (std::size_t k = 1; k <= kPieces; ++k) {
    floors_ = floors_.cwiseMax(samples_[k].values.cwiseAbs());
    if (k == kPieces) break;
    bend = bend.cwiseMax((samples_[k - 1].values - 2.0 * samples_[k].values +
                          samples_[k + 1].values)
                             .cwiseAbs());
  }
  bend *= kMargin;
  floors_ =
      (kPart * floors_).array() + kRoundOff * equations_.layout().length();
}

bool EventFinder::may_dip(const Sample& left, const Sample& right,
                          const VectorXd& bend) const {
  for (Eigen::Index i = 0; i < bend.size(); ++i) {
    if (numerics::may_dip(left.values[i], right.values[i], bend[i],
                          floors_[i])) {
      return true;
    }
  }
  return false;
}

bool EventFinder::any_negative(const Sample& sample) const {
  return (sample.values.array() < -floors_.array()).any();
}

/// Halves an interval as long as a function may be negative within it; bends
/// fall to a quarter with every halving.
EventFinder::Event EventFinder::find_between(numerics::Integrator& integrator,
                                             const Sample& left,
                                             const Sample& right, int depth) {
  constexpr double kMargin = 4.0, kLeast = 0.125;
  constexpr int kCareful = 3;
  const auto at = static_cast<std::size_t>(depth);
  if (depth == kDeepest || looks_left_ <= 0 ||
      !may_dip(left, right, bends_[at])) {
    return first_root(integrator, left, right);
  }
  --looks_left_;
  Sample& middle = middles_[at];
  middle.t = 0.5 * (left.t + right.t);
  look(integrator, middle.t, depth >= kCareful, middle.values);
  if (depth < kCareful && any_negative(middle)) {
    look(integrator, middle.t, true, middle.values);
  }
  bends_[at + 1] =
      (kMargin * (left.values - 2.0 * middle.values + right.values).cwiseAbs())
          .cwiseMax(kLeast * bends_[at]);
  const Event event = find_between(integrator, left, middle, depth + 1);
  if (event.index >= 0) return event;
  return find_between(integrator, middle, right, depth + 1);
}

/// First zero of what is negative at the right. What begins at zero must go
/// beyond round-off between samples.
EventFinder::Event EventFinder::first_root(numerics::Integrator& integrator,
                                           const Sample& left,
                                           const Sample& right) {
  Event first;
  const bool first_piece =
      left.t == integrator.t_start() && &right == &samples_[1];
  for (int i = 0; i < right.values.size(); ++i) {
    const bool begins = left.values[i] <= 0.0;
    const double least = begins && !first_piece ? -floors_[i] : 0.0;
    if (!(right.values[i] < least)) continue;
    const double t = root(integrator, i, left, right.t);
    if (first.index < 0 || t < first.t) first = {i, t};
  }
  return first;
}

}  // namespace clevis::mechanism
