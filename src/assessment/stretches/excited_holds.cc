#include "assessment/stretches/excited_holds.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "assessment/pace/load_pace.h"
#include "dynamics/load_vibration/response_spectrum.h"

namespace clevis::assessment {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

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

}  // namespace

dynamics::LoadPath ExcitedHolds::loads_within(
    const std::vector<VibrationWindow>& windows) const {
  LoadSet meanwhile = motion_;
  std::erase_if(meanwhile.history.instants, [&](const auto& instant) {
    return !lies_in(windows, instant.time);
  });
  return load_components(job_, meanwhile);
}

double ExcitedHolds::swept_answer(
    std::size_t instant, const std::vector<VibrationWindow>& driven) const {
  const auto within = instants_within(driven, motion_.history.instants);
  const dynamics::LoadPath path = loads_within(driven);
  if (path.size() != std::ssize(within)) return 0.0;
  double most = 0.0;
  for (const ExcitedMode& mode : modes_[instant].modes) {
    const VectorXd periods = followed_period(modes_, instant, mode.period);
    most = std::max(most, dynamics::swept_amplification(path, periods(within),
                                                        job_.part.damping));
  }
  return most;
}

ExcitedInstant ExcitedHolds::most_excited(
    const std::vector<std::size_t>& at,
    const std::vector<VibrationWindow>& windows,
    const std::vector<VibrationWindow>& loaded) const {
  // Of the time that is driven: where it dwells it is looked at there.
  constexpr int kLooks = 16;
  constexpr double kRoundOff = 1e-6;
  const auto& instants = motion_.history.instants;
  std::vector<double> until;
  double sum = 0.0;
  for (const std::size_t i : at) {
    until.push_back(
        sum += total_duration(in_both({nearest_times(instants, i)}, windows)));
  }
  const dynamics::LoadPath path = loads_within(loaded);
  ExcitedInstant most{at[(at.size() - 1) / 2], 0.0};
  for (int k = 0; k < kLooks; ++k) {
    const double share = (k + 0.5) / kLooks;
    const auto found = std::ranges::lower_bound(until, share * sum);
    if (found == until.end()) continue;
    const std::size_t i = at[static_cast<std::size_t>(found - until.begin())];
    const double answer =
        dynamics::response_spectrum(path, periods_of(modes_[i]),
                                    job_.part.damping, kPaceCounts)
            .amplification;
    // Of like ones the first.
    if (answer > (1.0 + kRoundOff) * most.answer) most = {i, answer};
  }
  return most;
}

}  // namespace clevis::assessment
