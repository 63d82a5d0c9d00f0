#include "assessment/notes/shear_doubt.h"

#include <algorithm>

#include <fmt/format.h>

#include "assessment/job/model_traits.h"
#include "assessment/judge/doubt.h"
#include "loads/pressure/surface_shear.h"
#include "stress/zones/end_of_shear.h"

namespace clevis::assessment {
namespace {

constexpr double kSmall = 1e-3;  // of the peak: not told

/// @return by how much [Pa].
double widen(const PartJob& job, PeakStress& peak) {
  double amount = 0.0;
  for (const LoadSet& set : job.load_sets) {
    amount = std::max(
        amount,
        stress::rise_at_edges(
            job.mesh, loads::surface_shear(set.history, job.groups), peak.at));
  }
  if (amount < kSmall * peak.value) return 0.0;
  widen_for_cells(peak, amount, job.tolerance);
  return amount;
}

}  // namespace

void add_shear_doubt(const PartJob& job, const PartFields& fields,
                     PartResult& result) {
  // A section that is turned sees it in its sequence of degrees.
  if (fields.dim != 3 || !(result.peak.value > 0.0) ||
      result.model.starts_with(traits_of(ModelKind::kRevolution).name)) {
    return;
  }
  const bool was_converged =
      judged_peak(result).verdict == PeakVerdict::kConverged;
  double amount = widen(job, result.peak);
  if (result.peak_outside) {
    amount = std::max(amount, widen(job, *result.peak_outside));
  }
  if (amount == 0.0) return;
  if (was_converged &&
      judged_peak(result).verdict == PeakVerdict::kNotConverged) {
    result.stopped_because = fmt::format(
        "shear of a load that ends at the edge beside the peak: {}, {:.3g} % "
        "wanted",
        doubt_text(judged_peak(result)), 100.0 * job.tolerance);
  }
  result.notes.push_back(fmt::format(
      "the peak stands at an edge where shear of a load ends: by up to {:.3g} "
      "MPa it may be more or less, which is in the band; a load that fades "
      "out, or a round at the edge, has no such doubt",
      amount * 1e-6));
}

}  // namespace clevis::assessment
