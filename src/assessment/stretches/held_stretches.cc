#include "assessment/stretches/held_stretches.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Core>

#include "assessment/pace/load_pace.h"
#include "assessment/stretches/slide_way.h"
#include "base/messages/errors.h"
#include "elasticity/vibration/eigenmodes.h"
#include "elasticity/vibration/seat_shapes.h"
#include "loads/history/motion_instants.h"

namespace clevis::assessment {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double kLike = 0.02;  // periods, as the width of a resonance

bool are_like(double shortest, double longest) {
  return longest - shortest <= kLike * longest;
}

/// Instants whose modes are like those of the first of their group: eight
/// groups at most, for which they may be farther apart.
std::vector<std::vector<std::size_t>> alike(
    const std::vector<HeldModes>& modes, const std::vector<std::size_t>& at) {
  constexpr std::size_t kMost = 8;
  std::vector<std::vector<std::size_t>> groups;
  for (double apart = kLike; apart < 2.0; apart *= 2.0) {  // 1: any period
    groups.clear();
    for (const std::size_t i : at) {
      const auto like = std::ranges::find_if(groups, [&](const auto& group) {
        return are_like(modes[group.front()], modes[i], apart);
      });
      if (like != groups.end()) {
        like->push_back(i);
      } else {
        groups.push_back({i});
      }
    }
    if (groups.size() <= kMost) break;
  }
  return groups;
}

/// Times that are nearer to an instant than to others.
VibrationWindow around(const std::vector<loads::InstantLoad>& instants,
                       std::size_t i) {
  const auto between = [&](std::size_t later) {
    return 0.5 * (instants[later - 1].time + instants[later].time);
  };
  return {i == 0 ? -HUGE_VAL : between(i),
          i + 1 == instants.size() ? HUGE_VAL : between(i + 1)};
}

double duration(const std::vector<VibrationWindow>& windows) {
  double sum = 0.0;
  for (const VibrationWindow& window : windows) sum += window.to - window.from;
  return sum;
}

/// Windows nearest to some instants; where these are closer together than the
/// instants, out to them.
std::vector<VibrationWindow> windows_at(
    const std::vector<loads::InstantLoad>& instants,
    const std::vector<std::size_t>& at,
    const std::vector<VibrationWindow>& driven) {
  std::vector<VibrationWindow> there, farther;
  for (const std::size_t i : at) {
    for (const VibrationWindow& window :
         in_both({around(instants, i)}, driven)) {
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

/// Whether the mechanism holds and weighs the same.
bool are_alike(const loads::SeatHold& a, const loads::SeatHold& b) {
  constexpr double kSame = 1e-6;
  const auto is_same = [](const MatrixXd& one, const MatrixXd& other) {
    const MatrixXd first = one * one.transpose();
    const MatrixXd second = other * other.transpose();
    return (first - second).norm() <= kSame * second.norm();
  };
  const auto swing_alike = [&] {
    if (!a.swinging || !b.swinging) return !a.swinging && !b.swinging;
    return is_same(a.swinging->held, b.swinging->held) &&
           is_same(a.swinging->followed, b.swinging->followed) &&
           is_same(a.swinging->sprung, b.swinging->sprung) &&
           is_same(a.swinging->sprung_there, b.swinging->sprung_there);
  };
  return is_same(a.held, b.held) && is_same(a.weighed, b.weighed) &&
         is_same(a.sprung, b.sprung) && swing_alike();
}

/// A frequency by itself, and the width of its resonance [1].
struct Resonance {
  double square{}, width{};
};

/// Whether springs of the mechanism move the part's first frequencies, or these
/// those of rigid bodies on the springs, or dampers nearly hold it: else
/// both vibrate by themselves. By less than a tenth of the damping ratio they
/// do not; a damper that only takes energy is left out on the safe side.
/// @param damping   of the part. @param duration  of the motion [s].
bool springs_count(const elasticity::SeatShapes& shapes,
                   const loads::SeatHold& hold, double damping,
                   double duration) {
  constexpr double kOfWidth = 0.1, kShort = 0.1;  // periods of a motion
  constexpr double kMost = 0.02, kRoundOff = 1e-6;
  constexpr double kHolding = 0.1;  // damping ratio
  constexpr double kElastic = 0.5;  // of the first square; less: rigid bodies'
  constexpr std::size_t kFirst = 6;
  if (!hold.is_sprung()) return false;
  loads::SeatHold unsprung = hold;
  unsprung.leave_springs_out();
  const auto held = shapes.held_by(hold);
  const Eigen::VectorXd& sprung = held.squares;
  const Eigen::VectorXd alone = shapes.held_by(unsprung).squares;
  const auto rigid = shapes.rigid_swings(hold);
  std::vector<Resonance> apart;
  const auto add = [&](double square, double ratio) {
    const double periods =
        std::sqrt(std::max(square, 0.0)) * duration / 2.0 / std::numbers::pi;
    const double width = std::max(ratio, kShort / std::max(periods, kShort));
    apart.push_back({square, std::min(kMost, width)});
  };
  for (const double square : alone) add(square, damping);
  for (Index k = 0; k < rigid.squares.size(); ++k) {
    add(rigid.squares[k], rigid.damping[k]);
  }
  std::ranges::sort(apart, {}, &Resonance::square);
  const std::size_t count =
      std::min({kFirst + static_cast<std::size_t>(rigid.squares.size()),
                apart.size(), static_cast<std::size_t>(sprung.size())});
  for (std::size_t k = 0; k < count; ++k) {
    const auto& [square, width] = apart[k];
    const double moved = std::abs(sprung[static_cast<Index>(k)] - square);
    if (moved > (2.0 * kOfWidth * width + kRoundOff) * square ||
        (sprung[static_cast<Index>(k)] > kElastic * alone[0] &&
         held.damping[static_cast<Index>(k)] > kHolding)) {
      return true;
    }
  }
  return false;
}

/// Of a body's momentum; less is round-off of bodies that turn in a plane.
bool spins(const loads::SeatHold& hold) {
  constexpr double kRoundOff = 1e-9;  // of masses per second
  return hold.spin.norm() >
         kRoundOff * (hold.weighed * hold.weighed.transpose()).norm();
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

/// First period at a place, from those of three, rising.
double between_places(const std::vector<std::pair<double, double>>& known,
                      double place) {
  for (std::size_t k = 1; k < known.size(); ++k) {
    const auto& [from, before] = known[k - 1];
    const auto& [to, after] = known[k];
    if (place > to && k + 1 < known.size()) continue;
    if (!(to > from)) continue;
    return before + (after - before) * (place - from) / (to - from);
  }
  return known.front().second;
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
  loads::LoadHistory& history = motion.loads.history;
  const bool has_slide = !motion.places.empty();
  if (!history.hold || !motion.loads.fixed.empty() ||
      !motion.loads.foundations.empty()) {
    return;
  }
  std::vector<loads::SeatHold> holds{history.hold(history.hold_time)};
  for (const std::size_t i : some_of(history.instants.size())) {
    holds.push_back(history.hold(history.instants[i].time));
  }
  const auto fastest =
      *std::ranges::max_element(holds, {}, [](const loads::SeatHold& hold) {
        return hold.spin.norm();
      });
  const auto change = [&] {
    return !has_slide && std::ranges::any_of(holds, [&](const auto& hold) {
      return !are_alike(hold, holds.front());
    });
  };
  const bool may_be_sprung =
      std::ranges::any_of(holds, &loads::SeatHold::is_sprung);
  if (!may_be_sprung && !change() && !spins(fastest)) return;
  const MatrixXd wrenches = elasticity::span_of(holds, seat_changes(history));
  make_solvers(motion);
  std::optional<elasticity::SeatShapes> shapes;
  for (auto& solver : motion.solvers) {
    try {
      shapes = solver.seat_shapes(wrenches, holds.front().zones);
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
  if (spins(fastest)) motion.moved = shapes->moved_by_spin(fastest);
  if (!change()) return;
  ExcitedModes excited(job_, motion.loads, *shapes);
  const HeldModes first = excited.of(holds.front());
  if (std::ranges::all_of(holds, [&](const loads::SeatHold& hold) {
        return clevis::assessment::are_like(first, excited.of(hold), kLike);
      })) {
    return;
  }
  for (const loads::InstantLoad& instant : history.instants) {
    loads::SeatHold hold = history.hold(instant.time);
    if (!history.springs_hold) hold.leave_springs_out();
    motion.modes.push_back(excited.of(hold));
  }
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

double HeldMotions::period_at(Motion& motion, std::size_t instant) const {
  constexpr double kSame = 1e-6;  // of the way
  const double along =
      (motion.places[instant] - motion.low) / (motion.high - motion.low);
  const auto [known, is_new] =
      motion.periods.try_emplace(std::llround(along / kSame));
  if (is_new) {
    known->second =
        period_held(motion, motion.loads.history.instants[instant].time);
  }
  return known->second;
}

HeldMotions::Motion& HeldMotions::motion(std::size_t set) {
  constexpr double kLittle = 1e-3;  // of the part's size: no way
  auto& found = motions_[set];
  if (found) return *found;
  found.emplace(followed_loads(job_.load_sets[set]));
  Motion& motion = *found;
  auto& places = motion.places;
  places = slide_way(motion.loads.history, kLittle * job_.sides()[2]);
  look_at_seats(motion);
  if (!motion.modes.empty()) {
    const auto slowest =
        std::ranges::max_element(motion.modes, {}, &HeldModes::first_period) -
        motion.modes.begin();
    motion.longest = period_held(
        motion,
        motion.loads.history.instants[static_cast<std::size_t>(slowest)].time);
    return motion;
  }
  if (places.empty()) {
    motion.longest = period_held(motion, motion.loads.history.hold_time);
    return motion;
  }
  const auto [low, high] = std::ranges::minmax_element(places);
  motion.low = *low;
  motion.high = *high;
  const double middle = 0.5 * (*low + *high);
  const auto nearest = std::ranges::min_element(places, {}, [&](double place) {
    return std::abs(place - middle);
  });
  double shortest = HUGE_VAL;
  for (const auto place : {low, high, nearest}) {
    const double period =
        period_at(motion, static_cast<std::size_t>(place - places.begin()));
    shortest = std::min(shortest, period);
    motion.longest = std::max(motion.longest, period);
  }
  if (are_like(shortest, motion.longest)) places.clear();
  return motion;
}

double HeldMotions::first_period(std::size_t set) {
  return motion(set).longest;
}

std::vector<HeldStretch> HeldMotions::stretches(
    std::size_t set, const std::vector<VibrationWindow>& driven) {
  constexpr int kHalvings = 3;
  Motion& of = motion(set);
  const auto& instants = of.loads.history.instants;
  Instants at;
  for (std::size_t i = 0; i < instants.size(); ++i) {
    if (!in_both({around(instants, i)}, driven).empty()) at.push_back(i);
  }
  const bool is_one = of.places.empty() && of.modes.empty();
  if (is_one || at.empty()) {
    return {{of.loads.history.hold_time, windows_at(instants, at, driven)}};
  }
  std::vector<HeldStretch> found;
  if (!of.modes.empty()) {
    const PeriodsOf periods = [&](std::size_t instant) {
      const auto& modes = of.modes[instant].modes;
      Eigen::VectorXd all(std::ssize(modes));
      std::ranges::transform(modes, all.begin(), &ExcitedMode::period);
      return all;
    };
    for (const Instants& group : alike(of.modes, at)) {
      found.push_back(stretch_of(of, group, driven, periods));
    }
    return found;
  }
  std::ranges::stable_sort(at, {}, [&](std::size_t i) {
    return of.places[i];
  });
  split(of, at, kHalvings, driven, found);
  return found;
}

void HeldMotions::split(Motion& motion, const Instants& at, int depth,
                        const std::vector<VibrationWindow>& driven,
                        std::vector<HeldStretch>& found) const {
  const double middle =
      0.5 * (motion.places[at.front()] + motion.places[at.back()]);
  const auto half = std::ranges::partition_point(at, [&](std::size_t i) {
    return motion.places[i] <= middle;
  });
  double shortest = HUGE_VAL, longest = 0.0;
  for (const std::size_t i : {at.front(), at.back(), *std::prev(half)}) {
    const double period = period_at(motion, i);
    shortest = std::min(shortest, period);
    longest = std::max(longest, period);
  }
  if (depth == 0 || half == at.end() || are_like(shortest, longest)) {
    found.push_back(
        stretch_of(motion, at, driven, periods_by_place(motion, at)));
    return;
  }
  split(motion, {at.begin(), half}, depth - 1, driven, found);
  split(motion, {half, at.end()}, depth - 1, driven, found);
}

HeldMotions::PeriodsOf HeldMotions::periods_by_place(Motion& motion,
                                                     const Instants& at) const {
  std::vector<std::pair<double, double>> known;
  for (const std::size_t i : {at.front(), at[(at.size() - 1) / 2], at.back()}) {
    known.emplace_back(motion.places[i], period_at(motion, i));
  }
  return [known, &motion](std::size_t i) {
    return Eigen::VectorXd::Constant(1,
                                     between_places(known, motion.places[i]));
  };
}

HeldStretch HeldMotions::stretch_of(const Motion& motion, const Instants& at,
                                    const std::vector<VibrationWindow>& driven,
                                    const PeriodsOf& periods) const {
  const auto& instants = motion.loads.history.instants;
  HeldStretch stretch{0.0, windows_at(instants, at, driven)};
  stretch.hold_time =
      instants[most_excited(motion, at, stretch.windows, periods)].time;
  return stretch;
}

std::size_t HeldMotions::most_excited(
    const Motion& motion, const Instants& at,
    const std::vector<VibrationWindow>& windows,
    const PeriodsOf& periods) const {
  // Of the time that is driven: where it dwells it is looked at there.
  constexpr int kLooks = 16;
  constexpr double kRoundOff = 1e-6;
  const auto& instants = motion.loads.history.instants;
  std::vector<double> until;
  double sum = 0.0;
  for (const std::size_t i : at) {
    until.push_back(sum += duration(in_both({around(instants, i)}, windows)));
  }
  LoadSet meanwhile = motion.loads;
  std::erase_if(meanwhile.history.instants, [&](const auto& instant) {
    return !lies_in(windows, instant.time);
  });
  const auto path = load_components(job_, meanwhile);
  std::size_t worst = at[(at.size() - 1) / 2];
  double most = 0.0;
  for (int k = 0; k < kLooks; ++k) {
    const double share = (k + 0.5) / kLooks;
    const auto found = std::ranges::lower_bound(until, share * sum);
    if (found == until.end()) continue;
    const std::size_t i = at[static_cast<std::size_t>(found - until.begin())];
    const double answer = dynamics::response_spectrum(
                              path, periods(i), job_.part.damping, kPaceCounts)
                              .amplification;
    if (!(answer > (1.0 + kRoundOff) * most))
      continue;  // of like ones the first
    most = answer;
    worst = i;
  }
  return worst;
}

std::vector<VibrationWindow> in_both(const std::vector<VibrationWindow>& a,
                                     const std::vector<VibrationWindow>& b) {
  std::vector<VibrationWindow> both;
  for (const VibrationWindow& one : a) {
    for (const VibrationWindow& other : b) {
      const VibrationWindow shared{std::max(one.from, other.from),
                                   std::min(one.to, other.to)};
      if (shared.to > shared.from) both.push_back(shared);
    }
  }
  return both;
}

}  // namespace clevis::assessment
