#include "assessment/facet_doubt.h"

#include <algorithm>
#include <numbers>

#include <fmt/format.h>

#include "stress/singular_zone.h"

namespace clevis::assessment {
namespace {

/// Of the kink [rad]: what the field of a surface in facets is off by from
/// mid-facet (0.44) to a tenth of a facet from its ends (0.5 ... 0.8).
constexpr double kOfKink = 0.8;
constexpr double kSmall = 1e-3;  // of the peak: not told

/// @return over the peak [1].
double widen(const PartJob& job, PeakStress& peak) {
  double kink = 0.0;
  for (const LoadSet& set : job.load_sets) {
    kink = std::max(kink, stress::facet_kink(job.mesh, set.fixed, peak.at));
  }
  const double error = kOfKink * kink;
  if (error < kSmall) return 0.0;
  const double amount = error * peak.value;
  peak.band_low = std::max(0.0, peak.band_low - amount);
  peak.band_high += amount;
  peak.discretization_error += amount;
  peak.shares.mesh += amount;
  if (peak.verdict == PeakVerdict::kConverged && error > job.tolerance) {
    peak.verdict = PeakVerdict::kNotConverged;
  }
  return error;
}

}  // namespace

void add_facet_doubt(const PartJob& job, PartResult& result) {
  if (!(result.peak.value > 0.0)) return;
  double error = widen(job, result.peak);
  if (!result.peak_outside.sequence.empty()) {
    error = std::max(error, widen(job, result.peak_outside));
  }
  if (error == 0.0) return;
  result.notes.push_back(fmt::format(
      "the peak stands on flat facets that kink by {:.2g}°: the curve behind "
      "them may have {:.2g} % more or less, which is in the band; mesh with "
      "order 2, or name its arcs round_…",
      error / kOfKink * 180.0 / std::numbers::pi, 100.0 * error));
}

}  // namespace clevis::assessment
