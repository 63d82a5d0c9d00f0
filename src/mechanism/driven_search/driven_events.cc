#include "mechanism/driven_search/driven_events.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "mechanism/sampling/driven_sampling.h"
#include "numerics/curves/brent.h"
#include "numerics/curves/dip.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

constexpr int kDeepest = 40;
constexpr int kMostHalvings = 400;  // between two looks
constexpr double kMargin = 4.0;     // of second differences, as bounds

/// Second derivative by three values, of a function of time.
VectorXd curvature(const DrivenTrajectory::Look& a,
                   const DrivenTrajectory::Look& b,
                   const DrivenTrajectory::Look& c) {
  return 2.0 *
         ((c.guards - b.guards) / (c.t - b.t) -
          (b.guards - a.guards) / (b.t - a.t)) /
         (c.t - a.t);
}

/// The same at the ends of an interval, times its length squared, by the cubic
/// through values and rates; 0 where no rate is known.
double cubic_bend(double a, double b, std::optional<double> rate_a,
                  std::optional<double> rate_b, double h) {
  if (!rate_a || !rate_b) return 0.0;
  const double rise = 6.0 * (b - a);
  return std::max(std::abs(rise - h * (4.0 * *rate_a + 2.0 * *rate_b)),
                  std::abs(rise - h * (2.0 * *rate_a + 4.0 * *rate_b)));
}

bool differ(double a, double b, double floor) {
  return (a > floor && b < -floor) || (a < -floor && b > floor);
}

/// Values that may vanish between without a change of sign.
bool hides(double a, double b, double bend, double floor) {
  if (differ(a, b, 0.0)) {
    // beyond one of the ends, and back
    return std::abs(b - a) < 0.5 * bend &&
           std::min(std::abs(a), std::abs(b)) < 0.125 * bend &&
           bend > 16.0 * floor;
  }
  const double sign = a + b < 0.0 ? -1.0 : 1.0;
  return numerics::may_dip(sign * a, sign * b, bend, floor);
}

}  // namespace

DrivenEvents::DrivenEvents(DrivenTrajectory& trajectory)
    : trajectory_(trajectory) {
  floors_.setZero(trajectory.guards().size());
  for (const auto& look : trajectory.looks()) {
    floors_ = floors_.cwiseMax(look.guards.cwiseAbs());
  }
  constexpr double kRoundOff = 1e-11;
  floors_ *= kRoundOff;
}

/// How much each guard may bend over the interval behind a look: its second
/// derivative times the length squared.
VectorXd DrivenEvents::bounds(At left) const {
  const At right = std::next(left);
  const double h = right->t - left->t;
  VectorXd bend = VectorXd::Zero(floors_.size());
  if (left != trajectory_.looks().begin()) {
    bend = curvature(*std::prev(left), *left, *right).cwiseAbs();
  }
  const At next = std::next(right);
  if (next != trajectory_.looks().end()) {
    bend = bend.cwiseMax(curvature(*left, *right, *next).cwiseAbs());
  }
  bend *= kMargin * h * h;
  for (Index i = 0; i < bend.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    bend[i] =
        std::max(bend[i], 2.0 * cubic_bend(left->guards[i], right->guards[i],
                                           left->rates[k], right->rates[k], h));
  }
  return bend;
}

void DrivenEvents::roots(At left, const End& a, const End& b) {
  for (Index i = 0; i < floors_.size(); ++i) {
    if (!differ(a.values[i], b.values[i], 0.0) ||
        !(std::max(std::abs(a.values[i]), std::abs(b.values[i])) >
          floors_[i])) {
      continue;
    }
    const double sign = a.values[i] > 0.0 ? 1.0 : -1.0;
    const auto value = [&](double t) {
      return sign * trajectory_.guards_between(left, t)[i];
    };
    const double t = numerics::brent_root(value, a.t, sign * a.values[i], b.t,
                                          sign * b.values[i]);
    if (!trajectory_.matters_between(left, t, i)) continue;
    (trajectory_.guards().jumps(i) ? found_ : bends_).push_back(t);
  }
}

void DrivenEvents::search(At left, const End& a, const End& b,
                          const VectorXd& bend, int depth) {
  bool hidden = false;
  for (Index i = 0; i < bend.size() && !hidden; ++i) {
    hidden = hides(a.values[i], b.values[i], bend[i], floors_[i]);
  }
  const double shortest = 4.0 * kSides * trajectory_.duration();
  const bool is_short = depth == kDeepest || b.t - a.t < shortest;
  if (hidden && !is_short && halvings_left_ <= 0) missed_ = true;
  if (!hidden || is_short || halvings_left_ <= 0) {
    roots(left, a, b);
    return;
  }
  --halvings_left_;
  constexpr double kLeast = 0.125;
  End middle{0.5 * (a.t + b.t), {}};
  middle.values = trajectory_.guards_between(left, middle.t);
  const VectorXd half =
      (kMargin * (a.values - 2.0 * middle.values + b.values).cwiseAbs())
          .cwiseMax(kLeast * bend);
  search(left, a, middle, half, depth + 1);
  search(left, middle, b, half, depth + 1);
}

/// Records the changes of the elements' modes between two looks.
void DrivenEvents::note_changes(At before, At behind, double t) {
  const std::vector<int> modes = trajectory_.modes_between(before, before->t);
  trajectory_.modes_between(before, behind->t);
  for (std::size_t k = 0; k < trajectory_.forces().size(); ++k) {
    for (const int end : {0, 1}) {
      const auto i = 2 * k + static_cast<std::size_t>(end);
      const char* what =
          trajectory_.forces().element(k).name_of_change(end, modes[i]);
      if (what != nullptr) events_.push_back({t, static_cast<int>(k), what});
    }
  }
}

/// A look at t, or the one that stands there already.
/// @param left  before t. @return nothing where J loses rank.
std::optional<DrivenEvents::At> DrivenEvents::side_at(At left, double t) {
  const double apart = 0.25 * kSides * trajectory_.duration();
  At last = left;
  while (std::next(last) != trajectory_.looks().end() &&
         std::next(last)->t <= t + apart) {
    ++last;
  }
  if (last->t >= t - apart || std::next(last) == trajectory_.looks().end()) {
    return last;
  }
  const auto look = trajectory_.look(last, t);
  if (look) (*look)->bend = last->bend;
  return look;
}

/// The events of an interval; that close to one of its ends have a side in
/// the interval beside it.
void DrivenEvents::add_sides(At left, const std::vector<double>& times) {
  const double side = 0.5 * kSides * trajectory_.duration();
  for (const double t : times) {
    const At from = t - side < left->t && left != trajectory_.looks().begin()
                        ? std::prev(left)
                        : left;
    const auto before = side_at(from, t - side);
    if (!before) continue;
    const auto behind = side_at(*before, t + side);
    if (!behind || *behind == *before) continue;
    (*before)->is_instant = (*behind)->is_instant = true;
    for (At i = *before; i != *behind; ++i) i->breaks = true;
    note_changes(*before, *behind, t);
  }
}

/// At a look at which a guard vanishes it still stands on the side that it
/// came from.
VectorXd DrivenEvents::values_behind(At left) const {
  VectorXd values = left->guards;
  if (left == trajectory_.looks().begin()) return values;
  const VectorXd& before = std::prev(left)->guards;
  for (Index i = 0; i < values.size(); ++i) {
    if (std::abs(values[i]) > floors_[i]) continue;
    values[i] = std::copysign(floors_[i], before[i]);
  }
  return values;
}

bool DrivenEvents::find(std::size_t most) {
  if (trajectory_.guards().empty()) return true;
  DrivenTrajectory::Looks& looks = trajectory_.looks();
  for (At i = looks.begin(); std::next(i) != looks.end(); ++i) {
    i->bend = bounds(i);
  }
  for (At left = looks.begin(); std::next(left) != looks.end();) {
    const At right = std::next(left);
    if (!left->breaks) {  // else a step of a law: nothing lies between
      if (looks.size() >= most) return false;
      halvings_left_ = kMostHalvings;
      found_.clear();
      bends_.clear();
      search(left, {left->t, values_behind(left)}, {right->t, right->guards},
             left->bend, 0);
      std::ranges::sort(found_);
      add_sides(left, found_);
      for (const double t : bends_) {
        const auto look = side_at(left, t);
        if (look) (*look)->bends = true;
      }
    }
    left = right;
  }
  return !missed_;
}

}  // namespace clevis::mechanism
