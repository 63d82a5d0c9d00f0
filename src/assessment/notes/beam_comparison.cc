#include "assessment/notes/beam_comparison.h"

#include <algorithm>

#include <fmt/format.h>

#include "assessment/judge/verdict.h"
#include "beam/estimates/beam_estimate.h"

namespace clevis::assessment {

BeamComparison compare_with_beam(const PartJob& job, const PartResult& result) {
  BeamComparison comparison;
  for (const LoadSet& set : job.load_sets) {
    const auto estimate =
        beam::estimate(job.mesh, job.part.material, job.mass, job.groups,
                       set.history, job.buckling_length);
    if (!estimate.stresses.empty() &&
        estimate.stresses.front().stress >
            comparison.peak_stress.value_or(0.0)) {
      comparison.peak_stress = estimate.stresses.front().stress;
      comparison.governing = estimate.stresses.front().formula + ", " +
                             estimate.stresses.front().where;
      comparison.is_section = estimate.stresses.front().is_section;
    }
    comparison.deflection =
        std::max(comparison.deflection, estimate.deflection);
    if (estimate.buckling &&
        (!comparison.buckling_safety ||
         estimate.buckling->safety < *comparison.buckling_safety)) {
      comparison.buckling_safety = estimate.buckling->safety;
    }
  }
  // of blows the held section's stress in time is no beam theory
  if (job.impacts.empty() && result.held &&
      result.held->value > comparison.peak_stress.value_or(0.0)) {
    comparison.peak_stress = result.held->value;
    comparison.is_section = false;  // it stands in PartResult::held
    comparison.governing = fmt::format(
        "section {} by its support's force and moment", result.held->section);
  }
  constexpr double kRoundOff = 1e-9;  // of formulas whose loads cancel
  if (comparison.peak_stress.value_or(0.0) <
      kRoundOff * judged_peak(result).value) {
    comparison.peak_stress.reset();
  }
  if (comparison.peak_stress) {
    comparison.ratio_fe_to_beam =
        judged_peak(result).value / *comparison.peak_stress;
  }
  const bool held = std::ranges::any_of(job.load_sets, [](const LoadSet& set) {
    return !set.fixed.empty() || !set.foundations.empty();
  });
  if (comparison.peak_stress || !held) {
    comparison.reason = explain_ratio(judged_peak(result), comparison);
  } else {
    comparison.reason =
        job.impacts.empty()
            ? "the supports are no plane sections, and no formula of lugs "
              "applies"
            : "the beam models of a blow stand in its own table";
  }
  return comparison;
}

}  // namespace clevis::assessment
