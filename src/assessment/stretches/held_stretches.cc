#include "assessment/stretches/held_stretches.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include <Eigen/Core>

#include "assessment/pace/load_pace.h"
#include "base/algebra/append_columns.h"
#include "base/messages/errors.h"
#include "elasticity/vibration/eigenmodes.h"
#include "elasticity/vibration/seat_shapes.h"
#include "loads/history/motion_instants.h"
#include "loads/holds/spread_seats.h"

namespace clevis::assessment {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kLike = 0.02;  // periods, as the width of a resonance

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

VectorXd periods_of(const HeldModes& held) {
  VectorXd all(std::ssize(held.modes));
  std::ranges::transform(held.modes, all.begin(), &ExcitedMode::period);
  return all;
}

/// Of a mode as its hold changes, by instant [s]: from one to the next that
/// which is nearest.
VectorXd followed_period(const std::vector<HeldModes>& modes,
                         std::size_t instant, double period) {
  constexpr double kLost = 1.3;  // none is it: as before
  const auto next = [&](double before, const HeldModes& held) {
    const auto off = [before](const ExcitedMode& mode) {
      return std::abs(std::log(mode.period / before));
    };
    const auto nearest = std::ranges::min_element(held.modes, {}, off);
    return nearest != held.modes.end() && off(*nearest) < std::log(kLost)
               ? nearest->period
               : before;
  };
  VectorXd all(std::ssize(modes));
  all[static_cast<Index>(instant)] = period;
  for (std::size_t i = instant + 1; i < modes.size(); ++i) {
    const auto at = static_cast<Index>(i);
    all[at] = next(all[at - 1], modes[i]);
  }
  for (std::size_t i = instant; i-- > 0;) {
    const auto at = static_cast<Index>(i);
    all[at] = next(all[at + 1], modes[i]);
  }
  return all;
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
/// @param apart  of sums of squares [1].
bool are_alike(const loads::SeatHold& a, const loads::SeatHold& b,
               double apart) {
  const auto is_same = [apart](const MatrixXd& one, const MatrixXd& other) {
    const MatrixXd first = one * one.transpose();
    const MatrixXd second = other * other.transpose();
    return (first - second).norm() <= apart * second.norm();
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
  const VectorXd& sprung = held.squares;
  const VectorXd alone = shapes.held_by(unsprung).squares;
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
  constexpr double kSameModes = 1e-3;  // likewise, far below kLike
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
      return !are_alike(hold, holds.front(), kSame);
    });
  };
  const bool may_be_sprung =
      std::ranges::any_of(holds, &loads::SeatHold::is_sprung);
  if (!may_be_sprung && !change() && !spins(fastest)) return;
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
  if (spins(fastest)) motion.moved = shapes->moved_by_spin(fastest);
  if (!change()) return;
  ExcitedModes excited(job_, motion.loads, seats, *shapes);
  const HeldModes first = excited.of(holds.front(), looks.front());
  bool are_all_like = true;
  for (std::size_t k = 1; k < looks.size() && are_all_like; ++k) {
    are_all_like = are_like(first, excited.of(holds[k], looks[k]), kLike);
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
    if (same != known.rend() && are_alike(hold_of(*same), hold, kSameModes)) {
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
  for (const Instants& group : alike(of.modes, all)) {
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
    if (!in_both({around(instants, i)}, driven).empty()) at.push_back(i);
  }
  if (of.modes.empty() || at.empty()) {
    return {{of.loads.history.hold_time, windows_at(instants, at, driven)}};
  }
  std::vector<HeldStretch> found;
  double apart = 0.0, staying = 0.0, swept = 0.0;
  for (const Instants& group : alike(of.modes, at)) {
    HeldStretch& stretch = found.emplace_back();
    apart = std::max(apart, excite(of, group, driven, stretch).answer);
    if (!of.travels) continue;
    const auto throughout = most_excited(of, group, stretch.windows, driven);
    staying = std::max(staying, throughout.answer);
    swept = std::max(swept, swept_answer(of, throughout.instant, driven));
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

HeldMotions::Excited HeldMotions::excite(
    const Motion& motion, const Instants& at,
    const std::vector<VibrationWindow>& driven, HeldStretch& stretch) const {
  const auto& instants = motion.loads.history.instants;
  stretch.windows = windows_at(instants, at, driven);
  // A swing that begins in them grows for another period.
  auto longer = stretch.windows;
  for (VibrationWindow& window : longer) window.to += motion.longest;
  const Excited found = most_excited(motion, at, stretch.windows,
                                     in_both(joined(longer), driven));
  stretch.hold_time = instants[found.instant].time;
  return found;
}

double HeldMotions::swept_answer(
    const Motion& motion, std::size_t instant,
    const std::vector<VibrationWindow>& driven) const {
  LoadSet meanwhile = motion.loads;
  const auto& instants = motion.loads.history.instants;
  const auto within = instants_within(driven, instants);
  meanwhile.history.instants.clear();
  for (const Index i : within) {
    meanwhile.history.instants.push_back(instants[static_cast<std::size_t>(i)]);
  }
  const auto path = load_components(job_, meanwhile);
  if (path.size() != std::ssize(within)) return 0.0;
  double most = 0.0;
  for (const ExcitedMode& mode : motion.modes[instant].modes) {
    const VectorXd periods =
        followed_period(motion.modes, instant, mode.period);
    most = std::max(most, dynamics::swept_amplification(path, periods(within),
                                                        job_.part.damping));
  }
  return most;
}

HeldMotions::Excited HeldMotions::most_excited(
    const Motion& motion, const Instants& at,
    const std::vector<VibrationWindow>& windows,
    const std::vector<VibrationWindow>& loaded) const {
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
    return !lies_in(loaded, instant.time);
  });
  const auto path = load_components(job_, meanwhile);
  Excited most{at[(at.size() - 1) / 2], 0.0};
  for (int k = 0; k < kLooks; ++k) {
    const double share = (k + 0.5) / kLooks;
    const auto found = std::ranges::lower_bound(until, share * sum);
    if (found == until.end()) continue;
    const std::size_t i = at[static_cast<std::size_t>(found - until.begin())];
    const double answer =
        dynamics::response_spectrum(path, periods_of(motion.modes[i]),
                                    job_.part.damping, kPaceCounts)
            .amplification;
    // Of like ones the first.
    if (answer > (1.0 + kRoundOff) * most.answer) most = {i, answer};
  }
  return most;
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
