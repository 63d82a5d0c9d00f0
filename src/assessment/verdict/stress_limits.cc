#include "assessment/verdict/stress_limits.h"

#include <optional>
#include <string>

#include <fmt/format.h>

#include "assessment/judge/doubt.h"
#include "assessment/verdict/governing_peak.h"
#include "assessment/verdict/hidden_stress.h"
#include "part/verdict.h"

namespace clevis::assessment {
namespace {

constexpr double kMega = 1e6;

std::string unsettled_remedy(const part::PartDefinition& part,
                             const PeakStress& peak) {
  if (peak.verdict == PeakVerdict::kSingular) {
    return "round the corner (mesh finer, if the surface is smooth there), or "
           "support the part without a sharp edge";
  }
  return fmt::format("in doubt by {}: {}", doubt_text(peak),
                     doubt_remedy(part, peak.shares));
}

/// What narrows a band that a limit lies in.
std::string limit_remedy(const part::PartDefinition& part,
                         const ErrorShares& shares) {
  const char* first = is_of_tolerance(shares) ? "tighten --tolerance, or " : "";
  return first + doubt_remedy(part, shares);
}

/// Whether a peak that is not converged lies within the limit all the same.
bool is_clearly_within(const PeakStress& peak, double reaches, double allowed) {
  return peak.verdict == PeakVerdict::kNotConverged && peak.has_band &&
         peak.value + reaches * (peak.band_high - peak.value) <= allowed;
}

/// A part whose stress is unbounded somewhere cannot pass unless the user
/// leaves such zones out; it can fail by its stress elsewhere.
bool is_singular_only(const part::PartDefinition& part,
                      const PartResult& result, double allowed) {
  return &judged_peak(result) != &result.peak &&
         !part.limits.exclude_singular_zones &&
         result.peak_outside->band_low <= allowed;
}

}  // namespace

std::optional<Judgement> judge_stress(const part::PartDefinition& part,
                                      const PartResult& result) {
  const PeakStress peak = governing_peak(result);
  const double allowed = allowed_stress(part);
  const bool is_decided =
      peak.verdict == PeakVerdict::kConverged ||
      (peak.verdict == PeakVerdict::kNotConverged && peak.band_low > allowed) ||
      is_clearly_within(peak, reaches_wanted(result), allowed);
  if (peak.value == 0.0 && result.peak.value > 0.0) {
    return Judgement{
        part::Verdict::kNotJudged,
        fmt::format("the singular zones cover the whole part ({}): mesh finer",
                    governing_zones(result))};
  }
  if (peak.value == 0.0) {
    return Judgement{
        part::Verdict::kNotJudged,
        "nothing stresses the part: its loads cancel, or act on held surfaces "
        "only"};
  }
  if (is_singular_only(part, result, allowed)) {
    return Judgement{
        part::Verdict::kNotJudged,
        fmt::format(
            "stress without bound at {}; elsewhere {:.4g} MPa ({}). Round the "
            "corner or spread the support, or judge without it by limits = {{ "
            "singular_zones = \"exclude\" }}",
            governing_zones(result), peak.value / kMega,
            peak.verdict == PeakVerdict::kConverged ? "converged"
                                                    : "not converged")};
  }
  if (!is_decided) {
    return Judgement{
        part::Verdict::kNotJudged,
        fmt::format("peak {} at {}: [{:.4g}, {:.4g}] MPa; {}",
                    peak.verdict == PeakVerdict::kSingular
                        ? "singular (grows without bound under refinement)"
                        : "not converged",
                    peak.group, peak.band_low / kMega, peak.band_high / kMega,
                    unsettled_remedy(part, peak))};
  }
  const std::string limit =
      part.limits.safety_factor
          ? fmt::format("{:.4g} MPa (safety factor {:.4g})", allowed / kMega,
                        *part.limits.safety_factor)
          : fmt::format("yield strength {:.4g} MPa", allowed / kMega);
  if (peak.band_low > allowed) {
    return Judgement{
        part::Verdict::kFail,
        fmt::format("peak {:.4g} MPa{} exceeds {}", peak.value / kMega,
                    result.vibration.governs ? " with vibration" : "", limit)};
  }
  if (peak.band_high > allowed) {
    const bool vibrates = result.vibration.governs;
    return Judgement{
        part::Verdict::kNotJudged,
        fmt::format("{} lies inside the band of the peak{}, [{:.4g}, {:.4g}] "
                    "MPa: {}",
                    limit, vibrates ? " with vibration" : "",
                    peak.band_low / kMega, peak.band_high / kMega,
                    vibrates ? "give the part its damping, or mesh finer"
                             : limit_remedy(part, peak.shares))};
  }
  const VibrationResult& vibration = result.vibration;
  if (!vibration.is_whole()) {
    const bool is_cut = vibration.failure.empty() && vibration.ratio;
    return Judgement{
        part::Verdict::kNotJudged,
        fmt::format("its vibration {} ({}), without {} the peak is {:.4g} MPa",
                    is_cut ? "is not wholly known" : "could not be computed",
                    vibration.failure.empty() ? vibration.not_followed
                                              : vibration.failure,
                    is_cut ? "the rest" : "it", peak.value / kMega)};
  }
  return std::nullopt;
}

std::optional<Judgement> judge_nominal(const part::PartDefinition& part,
                                       const PartResult& result) {
  if (!leaves_zones_out(part, result)) return std::nullopt;
  const std::optional<NominalStress> nominal = largest_nominal(result);
  const double allowed = allowed_stress(part);
  if (!nominal) return std::nullopt;
  const double more = largest_swing(result).stress * result.second_order.stress;
  if (nominal->high <= allowed && more * nominal->high > allowed) {
    return Judgement{
        part::Verdict::kNotJudged,
        fmt::format(
            "nominal stress {:.4g} MPa by linear theory at rest ({}), hidden "
            "by the zone left out: {:.4g} times with vibration, {:.4g} times "
            "in second order it may exceed {:.4g} MPa",
            nominal->value / kMega, nominal->what, largest_swing(result).stress,
            result.second_order.stress, allowed / kMega)};
  }
  if (nominal->high <= allowed) return std::nullopt;
  const bool fails = nominal->low > allowed;
  return Judgement{
      fails ? part::Verdict::kFail : part::Verdict::kNotJudged,
      fmt::format("nominal stress {:.4g} [{:.4g}, {:.4g}] MPa ({}), hidden by "
                  "the zone left out, {} {:.4g} MPa",
                  nominal->value / kMega, nominal->low / kMega,
                  nominal->high / kMega, nominal->what,
                  fails ? "exceeds" : "may exceed", allowed / kMega)};
}

}  // namespace clevis::assessment
