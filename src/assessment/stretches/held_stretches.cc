#include "assessment/stretches/held_stretches.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <Eigen/Core>

#include "assessment/pace/load_pace.h"
#include "assessment/stretches/counting_springs.h"
#include "assessment/stretches/excited_holds.h"
#include "base/algebra/append_columns.h"
#include "base/messages/errors.h"
#include "elasticity/vibration/eigenmodes.h"
#include "elasticity/vibration/seat_shapes.h"
#include "loads/history/motion_instants.h"
#include "loads/holds/seat_hold.h"
#include "loads/holds/spread_seats.h"

namespace clevis::assessment {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Windows nearest to some instants; where these are closer together than the
/// instants, out to them.
std::vector<VibrationWindow> windows_at(
    const std::vector<loads::InstantLoad>& instants,
    const std::vector<std::size_t>& at,
    const std::vector<VibrationWindow>& driven) {
  std::vector<VibrationWindow> there, farther;
  for (const std::size_t i : at) {
    for (const VibrationWindow& window :
         in_both({nearest_times(instants, i)}, driven)) {
      const double time = instants[i].time;
      there.push_back(window);
      farther.push_back(
          {std::min(window.from, time), std::max(window.to, time)});
    }
  }
  there = joined(std::move(there));
  return instants_within(there, instants).empty() ? joined(std::move(farther))
                                                  : there;
}

std::size_t next_to(double time,
                    const std::vector<loads::InstantLoad>& instants) {
  const auto nearest = std::ranges::min_element(
      instants, {}, [&](const loads::InstantLoad& load) {
        return std::abs(load.time - time);
      });
  return static_cast<std::size_t>(nearest - instants.begin());
}

/// So many instants at most, as evenly as they stand.
std::vector<std::size_t> some_of(std::size_t instants) {
  constexpr std::size_t kMost = 33;
  const std::size_t count = std::min(kMost, instants);
  std::vector<std::size_t> some;
  for (std::size_t k = 0; k < count; ++k) {
    some.push_back(count == 1 ? 0 : k * (instants - 1) / (count - 1));
  }
  return some;
}

}  // namespace

void HeldMotions::make_solvers(Motion& motion) const {
  if (!motion.solvers.empty()) return;
  const bool is_simplex = job_.mesh.shape == mesh::CellShape::kSimplex;
  for (const int degree : {2, 1}) {  // memory may hold less
    if (degree == 1 && !is_simplex) continue;
    motion.solvers.emplace_back(
        elasticity::ElasticProblem<3>{.mesh = job_.overall_mesh(),
                                      .material = job_.part.material,
                                      .history = motion.loads.history,
                                      .fixed = motion.loads.fixed,
                                      .name = job_.part.name,
                                      .foundations = motion.loads.foundations},
        degree);
  }
}

void HeldMotions::look_at_seats(Motion& motion) const {
  constexpr int kSteps = 16;           // of a slide's way
  constexpr double kLittle = 1e-3;     // of the part's size: no way
  constexpr double kSame = 1e-6;       // of holds
  constexpr double kSameModes = 1e-3;  // likewise, far below kLikePeriods
  loads::LoadHistory& history = motion.loads.history;
  if (!history.hold || !motion.loads.fixed.empty() ||
      !motion.loads.foundations.empty()) {
    return;
  }
  const loads::SpreadSeats seats(history, kSteps, kLittle * job_.sides()[2]);
  const auto hold_at = [&](std::size_t instant) {
    return seats.spread(history.hold(history.instants[instant].time), instant);
  };
  std::vector<std::size_t> looks{next_to(history.hold_time, history.instants)};
  for (const std::size_t i : some_of(history.instants.size())) {
    looks.push_back(i);
  }
  // Of evenly spread ones there may be none where a slide goes fast.
  looks.insert(looks.end(), seats.instants().begin(), seats.instants().end());
  std::vector<loads::SeatHold> holds;
  for (const std::size_t i : looks) holds.push_back(hold_at(i));
  const auto fastest =
      *std::ranges::max_element(holds, {}, [](const loads::SeatHold& hold) {
        return hold.spin.norm();
      });
  const auto change = [&] {
    return std::ranges::any_of(holds, [&](const loads::SeatHold& hold) {
      return !loads::are_alike(hold, holds.front(), kSame);
    });
  };
  const bool may_be_sprung =
      std::ranges::any_of(holds, &loads::SeatHold::is_sprung);
  if (!may_be_sprung && !change() && !loads::has_spin(fastest)) return;
  const MatrixXd of_seats = seat_changes(history);
  MatrixXd changes(0, 0);
  for (const std::size_t i : looks) {
    append_columns(seats.spread(of_seats, i), changes);
    append_columns(seats.spread(seat_wrenches(history.instants[i]), i),
                   changes);
  }
  const MatrixXd wrenches = elasticity::span_of(holds, changes);
  make_solvers(motion);
  std::optional<elasticity::SeatShapes> shapes;
  for (auto& solver : motion.solvers) {
    try {
      shapes = solver.seat_shapes(wrenches, seats.seats(), holds.front().zones,
                                  change());
      break;
    } catch (const Error&) {
      continue;
    }
  }
  if (!shapes) return;
  history.springs_hold =
      may_be_sprung && std::ranges::any_of(holds, [&](const auto& hold) {
        return springs_count(*shapes, hold, job_.part.damping,
                             loads::motion_duration(history));
      });
  if (!history.springs_hold) {
    for (loads::SeatHold& hold : holds) hold.leave_springs_out();
  }
  if (loads::has_spin(fastest)) motion.moved = shapes->moved_by_spin(fastest);
  if (!change()) return;
  ExcitedModes excited(job_, motion.loads, seats, *shapes);
  const HeldModes first = excited.of(holds.front(), looks.front());
  bool are_all_like = true;
  for (std::size_t k = 1; k < looks.size() && are_all_like; ++k) {
    are_all_like =
        are_like(first, excited.of(holds[k], looks[k]), kLikePeriods);
  }
  if (are_all_like) return;
  motion.travels = seats.travels();
  const auto hold_of = [&](std::size_t instant) {
    return hold_at_instant(motion, instant);
  };
  std::vector<std::size_t> known;
  for (std::size_t i = 0; i < history.instants.size(); ++i) {
    const loads::SeatHold hold = hold_of(i);
    const auto same =
        std::find_if(known.rbegin(), known.rend(), [&](std::size_t other) {
          return seats.stand_alike(i, other);
        });
    if (same != known.rend() &&
        loads::are_alike(hold_of(*same), hold, kSameModes)) {
      motion.modes.push_back(motion.modes[*same]);
      continue;
    }
    known.push_back(i);
    motion.modes.push_back(excited.of(seats.spread(hold, i), i));
  }
  motion.seats = seats;
  motion.shapes = std::move(shapes);
}

std::optional<TravellingVibration> HeldMotions::followed(
    std::size_t set, const std::vector<HeldStretch>& stretches) {
  Motion& of = motion(set);
  if (of.modes.empty()) return std::nullopt;
  const auto& instants = of.loads.history.instants;
  CountedPeriods periods{HUGE_VAL, 0.0};
  for (const HeldModes& held : of.modes) {
    const CountedPeriods own = counted_periods(held);
    periods.shortest = std::min(periods.shortest, own.shortest);
    periods.longest = std::max(periods.longest, own.longest);
  }
  if (!(periods.longest > 0.0)) return std::nullopt;
  std::vector<std::size_t> as_if_held;
  for (const HeldStretch& stretch : stretches) {
    if (!of.travels) as_if_held.push_back(next_to(stretch.hold_time, instants));
  }
  auto found = follow_holds(
      job_, of.loads, *of.seats, *of.shapes,
      [&](std::size_t instant) {
        return hold_at_instant(of, instant);
      },
      periods, as_if_held);
  if (!found) return found;
  found->lowest =
      1.0 / counted_periods(of.modes[next_to(found->time, instants)]).longest;
  return found;
}

loads::SeatHold HeldMotions::hold_at_instant(const Motion& motion,
                                             std::size_t instant) {
  const loads::LoadHistory& history = motion.loads.history;
  loads::SeatHold hold = history.hold(history.instants[instant].time);
  if (!history.springs_hold) hold.leave_springs_out();
  return hold;
}

double HeldMotions::period_held(Motion& motion, double time) const {
  make_solvers(motion);
  for (auto& solver : motion.solvers) {
    try {
      return solver.at(time);
    } catch (const Error&) {
      continue;
    }
  }
  // Supports that hold it in a plane alone.
  return longest_period(job_, motion.loads);
}

HeldMotions::Motion& HeldMotions::motion(std::size_t set) {
  auto& found = motions_[set];
  if (found) return *found;
  found.emplace(followed_loads(job_.load_sets[set]));
  Motion& motion = *found;
  look_at_seats(motion);
  const loads::LoadHistory& history = motion.loads.history;
  motion.longest =
      motion.modes.empty()
          ? period_held(motion, history.hold_time)
          : std::ranges::max(motion.modes, {}, &HeldModes::first_period)
                .first_period;
  return motion;
}

double HeldMotions::first_period(std::size_t set) {
  return motion(set).longest;
}

std::vector<HeldMeanwhile> HeldMotions::meanwhile(std::size_t set) {
  const Motion& of = motion(set);
  if (of.modes.empty()) return {};
  Instants all(of.modes.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::vector<HeldMeanwhile> found;
  for (const Instants& group : like_instants(of.modes, all)) {
    HeldMeanwhile& held = found.emplace_back(HeldMeanwhile{of.loads});
    auto& instants = held.motion.history.instants;
    instants.clear();
    double first = 0.0;
    for (const std::size_t i : group) {
      instants.push_back(of.loads.history.instants[i]);
      first = std::max(first, of.modes[i].first_period);
      held.period = std::max(held.period, counted_periods(of.modes[i]).longest);
    }
    if (held.period == 0.0) held.period = first;
  }
  return found;
}

std::vector<HeldStretch> HeldMotions::stretches(
    std::size_t set, const std::vector<VibrationWindow>& driven) {
  Motion& of = motion(set);
  const auto& instants = of.loads.history.instants;
  Instants at;
  for (std::size_t i = 0; i < instants.size(); ++i) {
    if (!in_both({nearest_times(instants, i)}, driven).empty()) at.push_back(i);
  }
  if (of.modes.empty() || at.empty()) {
    return {{of.loads.history.hold_time, windows_at(instants, at, driven)}};
  }
  std::vector<HeldStretch> found;
  const ExcitedHolds excited(job_, of.loads, of.modes);
  double apart = 0.0, staying = 0.0, swept = 0.0;
  for (const Instants& group : like_instants(of.modes, at)) {
    HeldStretch& stretch = found.emplace_back();
    stretch.windows = windows_at(instants, group, driven);
    // A swing that begins in them grows for another period.
    auto longer = stretch.windows;
    for (VibrationWindow& window : longer) window.to += of.longest;
    const auto within = excited.most_excited(
        group, stretch.windows, in_both(joined(std::move(longer)), driven));
    stretch.hold_time = instants[within.instant].time;
    apart = std::max(apart, within.answer);
    if (!of.travels) continue;
    const auto throughout =
        excited.most_excited(group, stretch.windows, driven);
    staying = std::max(staying, throughout.answer);
    swept = std::max(swept, excited.swept_answer(throughout.instant, driven));
  }
  // It does not stay where it is in resonance, or not in one stretch.
  constexpr double kPasses = 1.5, kFarther = 1.1;
  if (swept > 0.0 && (staying > kPasses * swept || swept > kFarther * apart)) {
    // As far as one oscillator is a mode whose shape changes with its period.
    constexpr double kUncertain = 2.0;
    for (HeldStretch& stretch : found) stretch.swept = kUncertain * swept;
  }
  return found;
}

}  // namespace clevis::assessment
