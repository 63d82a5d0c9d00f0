#include "assessment/stretches/excited_modes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assessment/pace/load_pace.h"
#include "dynamics/load_vibration/response_spectrum.h"

namespace clevis::assessment {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kCounts = 0.05;  // of the mode that answers most
constexpr double kKept = 0.01;    // with another hold it may count

bool has_all_of(const HeldModes& a, const HeldModes& b, double apart) {
  return std::ranges::all_of(a.modes, [&](const ExcitedMode& one) {
    return one.answer < kCounts ||
           std::ranges::any_of(b.modes, [&](const ExcitedMode& other) {
             return std::abs(one.period - other.period) <=
                    apart * std::max(one.period, other.period);
           });
  });
}

}  // namespace

double longest_of_part(const VectorXd& periods, const VectorXd& own_share) {
  constexpr double kStrained = 0.01;
  const auto strained = own_share.array() > kStrained;
  return strained.select(periods.array(), periods.minCoeff()).maxCoeff();
}

VectorXd seat_wrenches(const loads::InstantLoad& instant) {
  constexpr Index kWrench = 6;
  VectorXd all(kWrench * std::ssize(instant.wrenches));
  for (std::size_t s = 0; s < instant.wrenches.size(); ++s) {
    all.segment<kWrench>(kWrench * static_cast<Index>(s))
        << instant.wrenches[s].force,
        instant.wrenches[s].moment;
  }
  return all;
}

CountedPeriods counted_periods(const HeldModes& held) {
  CountedPeriods periods{HUGE_VAL, 0.0};
  for (const ExcitedMode& mode : held.modes) {
    if (mode.answer < kCounts) continue;
    periods.shortest = std::min(periods.shortest, mode.period);
    periods.longest = std::max(periods.longest, mode.period);
  }
  return periods;
}

bool are_like(const HeldModes& a, const HeldModes& b, double apart) {
  return has_all_of(a, b, apart) && has_all_of(b, a, apart);
}

std::vector<std::vector<std::size_t>> like_instants(
    const std::vector<HeldModes>& modes, const std::vector<std::size_t>& at) {
  constexpr std::size_t kMost = 8;
  std::vector<std::vector<std::size_t>> groups;
  for (double apart = kLikePeriods; apart < 2.0;
       apart *= 2.0) {  // 1: any period
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

MatrixXd seat_changes(const loads::LoadHistory& motion) {
  constexpr double kNothing = 1e-6;  // of the largest change
  constexpr Index kSome = 64, kVector = 3;
  const Index count = std::ssize(motion.instants);
  if (count == 0) return {};
  const VectorXd first = seat_wrenches(motion.instants.front());
  MatrixXd all(first.size(), count);
  for (Index i = 0; i < count; ++i) {
    all.col(i) =
        seat_wrenches(motion.instants[static_cast<std::size_t>(i)]) - first;
  }
  std::vector<Index> taken;
  for (Index k = 0; k < std::min(kSome, count); ++k) {
    taken.push_back(count <= kSome ? k : k * (count - 1) / (kSome - 1));
  }
  for (Index row = 0; row < all.rows(); row += kVector) {
    Index most = 0;
    all.middleRows(row, kVector).colwise().norm().maxCoeff(&most);
    taken.push_back(most);
  }
  const VectorXd size = all.colwise().norm();
  const double largest = size.maxCoeff();
  std::erase_if(taken, [&](Index i) {
    return !(size[i] > kNothing * largest);
  });
  std::ranges::sort(taken);
  taken.erase(std::unique(taken.begin(), taken.end()), taken.end());
  return all(Eigen::all, taken);
}

ExcitedModes::ExcitedModes(const PartJob& job, const LoadSet& motion,
                           const loads::SpreadSeats& seats,
                           const elasticity::SeatShapes& shapes)
    : seats_(seats),
      shapes_(shapes),
      path_(load_components(job, motion)),
      damping_(job.part.damping),
      changes_(seat_changes(motion.history)),
      has_others_(std::ranges::any_of(motion.history.instants,
                                      [](const loads::InstantLoad& instant) {
                                        return !instant.surface_loads.empty();
                                      })) {}

double ExcitedModes::amplification(double period) {
  constexpr double kStep = 0.02;  // as the width of a resonance
  const auto [known, is_new] =
      amplifications_.try_emplace(std::llround(std::log(period) / kStep));
  if (is_new) {
    const double there = std::exp(kStep * static_cast<double>(known->first));
    known->second =
        dynamics::response_spectrum(path_, VectorXd::Constant(1, there),
                                    damping_, kPaceCounts)
            .amplification;
  }
  return known->second;
}

HeldModes ExcitedModes::of(const loads::SeatHold& hold, std::size_t instant) {
  constexpr Index kFirst = 6;
  constexpr double kRoundOff = 1e-12;  // of squares: no vibration
  const auto vibrations = shapes_.held_by(hold);
  const Index count = vibrations.squares.size();
  const VectorXd squares =
      vibrations.squares.cwiseMax(kRoundOff * vibrations.squares.maxCoeff());
  const VectorXd periods =
      2.0 * std::numbers::pi * squares.cwiseSqrt().cwiseInverse();
  const MatrixXd changes =
      shapes_.along_seats(seats_.spread(changes_, instant));
  VectorXd answers(count);
  for (Index k = 0; k < count; ++k) {
    const double bent = changes.cols() > 0
                            ? (vibrations.bending.col(k).transpose() * changes)
                                  .lpNorm<Eigen::Infinity>()
                            : 0.0;
    answers[k] = bent * std::sqrt(vibrations.own_share[k] / squares[k]);
    if (answers[k] > 0.0) answers[k] *= amplification(periods[k]);
  }
  const double most = answers.size() > 0 ? answers.maxCoeff() : 0.0;
  answers /= most > 0.0 ? most : 1.0;
  // Where other loads excite them they count as far as parts are soft.
  if (has_others_) answers.head(std::min(kFirst, count)).setOnes();
  // Few shapes have those far above the first that counts only roughly.
  constexpr double kShortest = 0.1;
  HeldModes found{longest_of_part(periods, vibrations.own_share), {}};
  double longest = 0.0;
  for (Index k = 0; k < count; ++k) {
    if (answers[k] < kKept || periods[k] < kShortest * longest) continue;
    found.modes.push_back({periods[k], answers[k]});
    if (longest == 0.0 && answers[k] >= kCounts) longest = periods[k];
  }
  return found;
}

}  // namespace clevis::assessment
