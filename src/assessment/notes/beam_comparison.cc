#include "assessment/notes/beam_comparison.h"

#include <algorithm>

#include <fmt/format.h>

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

std::string explain_ratio(const PeakStress& peak, const BeamComparison& beam) {
  constexpr double kLargestConcentration = 5.0;  // of holes and fillets
  if (!beam.ratio_fe_to_beam) return "no beam formula applies";
  const double ratio = *beam.ratio_fe_to_beam;
  if (ratio >= 0.8 && ratio <= 1.25) return "";
  const std::string& group = peak.group;
  if (ratio > 1.25) {
    if (ratio > kLargestConcentration) {
      return fmt::format("\"{}\" does not describe what loads {}",
                         beam.governing, group);
    }
    if (group.starts_with("bore_")) {
      return fmt::format(
          "the hole concentrates the stress at {} by {:.2f} over the nominal "
          "\"{}\"",
          group, ratio, beam.governing);
    }
    if (group.starts_with("round_") || group.starts_with("fillet")) {
      return fmt::format(
          "the change of section at {} concentrates the stress by {:.2f}",
          group, ratio);
    }
    return fmt::format("the load path near {} is not a slender beam's", group);
  }
  return fmt::format(
      "\"{}\" is a nominal value for slender parts; here the part is stocky "
      "and the load spreads",
      beam.governing);
}

}  // namespace clevis::assessment
