#include "assessment/vibration/pulsing_loads.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "assessment/pace/load_pace.h"
#include "assessment/vibration/duration_ratio.h"
#include "dynamics/load_vibration/pulsed_oscillator.h"

namespace clevis::assessment {
namespace {

/// Largest growth of the first vibration's disturbances in a motion [1].
/// @param share  of its stiffness that the loads take at most [1].
double growth(const PartJob& job, const LoadSet& set, double period,
              double share) {
  constexpr double kOff = 0.03;  // of the period
  constexpr double kStep = 0.01;
  constexpr double kMostPeriods = 5e3;
  const dynamics::LoadPath path = load_components(job, followed_loads(set));
  if (path.size() < 3) return 1.0;
  const double duration = path.time()[path.size() - 1] - path.time()[0];
  if (duration > kMostPeriods * period) return 1.0;
  double most = 1.0;
  // What stands still of the loads lowers the frequency, too.
  const double longest = (1.0 + kOff) / std::sqrt(1.0 - share);
  for (double times = 1.0 - kOff; times <= longest; times += kStep) {
    for (Eigen::Index k = 0; k < path.coordinates(); ++k) {
      most = std::max(most,
                      dynamics::pulsed_growth(
                          path, k, {times * period, job.part.damping, share}));
    }
  }
  return most;
}

}  // namespace

void doubt_pulsing_loads(const PartJob& job, PartResult& result) {
  constexpr double kGrows = 1.3;  // beyond what a softer spring lets it swing
  constexpr double kCounts = 0.01, kMost = 0.9;  // shares
  if (!result.first_period || !result.vibration.not_followed.empty()) return;
  for (std::size_t s = 0; s < job.load_sets.size(); ++s) {
    if (s >= result.buckling.of_motions.size()) return;
    const double share = std::min(kMost, 1.0 / result.buckling.of_motions[s]);
    if (share < kCounts) continue;
    const double grown =
        growth(job, job.load_sets[s], *result.first_period, share);
    if (grown < kGrows / (1.0 - share)) continue;
    result.vibration.not_followed = fmt::format(
        "its loads take up to {:.2g} of its stiffness, and pulse so that small "
        "swings may grow {} (parametric resonance): keep them off twice its "
        "first frequency, {:.4g} Hz, and off that itself",
        share,
        grown < 1e3 ? fmt::format("to {:.2g} times", grown) : "without bound",
        1.0 / *result.first_period);
    return;
  }
}

}  // namespace clevis::assessment
