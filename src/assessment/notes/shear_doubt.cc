#include "assessment/notes/shear_doubt.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "assessment/job/model_traits.h"
#include "assessment/judge/doubt.h"
#include "loads/pressure/surface_shear.h"
#include "stress/zones/end_of_shear.h"

namespace clevis::assessment {
namespace {

constexpr double kSmall = 1e-3;  // of the peak: not told

/// Of each load set.
std::vector<std::vector<stress::SharpEnd>> ends_by_set(const PartJob& job) {
  std::vector<std::vector<stress::SharpEnd>> ends;
  for (const LoadSet& set : job.load_sets) {
    ends.push_back(stress::sharp_ends(
        job.mesh, loads::surface_shear(set.history, job.groups)));
  }
  return ends;
}

/// @return by how much, where the peak stands at an edge [Pa].
double widen(const PartJob& job,
             const std::vector<std::vector<stress::SharpEnd>>& by_set,
             PeakStress& peak) {
  double amount = 0.0;
  for (const auto& ends : by_set) {
    amount = std::max(amount, stress::rise_beside(ends, peak.at));
  }
  if (amount < kSmall * peak.value) return 0.0;
  widen_for_cells(peak, amount, job.tolerance);
  return amount;
}

/// Raises the band to what the loads of a set alone may make at the corners of
/// their faces. @return by how much [Pa].
double raise(const PartJob& job,
             const std::vector<std::vector<stress::SharpEnd>>& by_set,
             PeakStress& peak) {
  double highest = 0.0;
  for (const auto& ends : by_set) {
    highest = std::max(highest, stress::stress_at_corners(ends));
  }
  const double more = highest - peak.band_high;
  if (more < kSmall * peak.value) return 0.0;
  const double low = peak.band_low;
  widen_for_cells(peak, more, job.tolerance);
  peak.band_low = low;
  return more;
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
  PeakStress& judged = result.peak_outside ? *result.peak_outside : result.peak;
  const auto ends = ends_by_set(job);
  double amount = widen(job, ends, result.peak);
  if (result.peak_outside) {
    amount = std::max(amount, widen(job, ends, *result.peak_outside));
  }
  const double more = raise(job, ends, judged);
  if (amount == 0.0 && more == 0.0) return;
  if (was_converged &&
      judged_peak(result).verdict == PeakVerdict::kNotConverged) {
    result.stopped_because =
        fmt::format("shear of a load that ends at an edge: {}, {:.3g} % wanted",
                    doubt_text(judged_peak(result)), 100.0 * job.tolerance);
  }
  if (amount > 0.0) {
    result.notes.push_back(fmt::format(
        "the peak stands at an edge where shear of a load ends: by up to "
        "{:.3g} "
        "MPa it may be more or less, which is in the band; a load that fades "
        "out, or a round at the edge, has no such doubt",
        amount * 1e-6));
  }
  if (more > 0.0) {
    result.notes.push_back(fmt::format(
        "at a corner of the face that takes it a load's shear may exceed the "
        "peak's band by {:.3g} MPa, which is in the band now; a load that "
        "fades "
        "out, or a round face, has no such doubt",
        more * 1e-6));
  }
}

}  // namespace clevis::assessment
