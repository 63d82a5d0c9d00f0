#include "assessment/verdict/verdict.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "assessment/judge/doubt.h"
#include "assessment/judge/finite_motion.h"
#include "assessment/verdict/governing_peak.h"
#include "assessment/verdict/hidden_stress.h"
#include "assessment/verdict/judgement.h"
#include "assessment/verdict/stability_limits.h"
#include "assessment/verdict/stress_limits.h"
#include "part/verdict.h"

namespace clevis::assessment {
namespace {

constexpr double kMilli = 1e-3;

/// Of a part that passes though its peak is not converged.
std::string wide_band(const PartResult& result) {
  const PeakStress& peak = judged_peak(result);
  if (peak.verdict != PeakVerdict::kNotConverged) return "";
  return fmt::format(
      "by its band, which lies within the limit as a whole though the peak is "
      "not converged ({})",
      doubt_text(peak));
}

/// At rest or as it vibrates.
FiniteMotion farthest(const PartResult& result) {
  FiniteMotion motion = result.finite_motion;
  const double swing = largest_swing(result).largest();
  motion.rotation *= swing;
  motion.strain *= swing;
  return motion;
}

/// Refuses a verdict on large rotations or strains: linear theory knows no
/// stress of them.
std::optional<Judgement> judge_finite_motion(const part::PartDefinition&,
                                             const PartResult& result) {
  std::string why = beyond_small_displacements(farthest(result));
  if (why.empty()) return std::nullopt;
  return Judgement{part::Verdict::kNotJudged, std::move(why)};
}

std::optional<Judgement> judge_deflection(const part::PartDefinition& part,
                                          const PartResult& result) {
  if (!part.limits.deflection) return std::nullopt;
  const double limit = *part.limits.deflection;
  const bool has_band = result.deflection_high > 0.0;
  const double most = has_band ? result.deflection_high : result.deflection;
  const double least = has_band ? result.deflection_low : result.deflection;
  const SecondOrderResult& found = result.second_order;
  const auto times_linear = [&](double value) {
    return result.deflection > 0.0 ? std::max(1.0, value / result.deflection)
                                   : 1.0;
  };
  const double more = times_linear(found.deflection);
  const double high = std::max(more * most, found.deflection_bound);
  if (high <= limit) return std::nullopt;
  const double low = times_linear(found.least_deflection) * least;
  if (low <= limit) {
    const ErrorShares& shares = judged_peak(result).shares;
    const bool is_shared = shares.sharing > shares.mesh;
    return Judgement{
        part::Verdict::kNotJudged,
        fmt::format("{:.4g} mm lies inside the band of the deflection{}, "
                    "[{:.4g}, {:.4g}] mm: {}",
                    limit / kMilli, more > 1.01 ? " in second order" : "",
                    low / kMilli, high / kMilli,
                    is_shared ? doubt_remedy(part, {.sharing = shares.sharing})
                              : "mesh finer")};
  }
  return Judgement{
      part::Verdict::kFail,
      fmt::format("deflection {:.4g} mm{} exceeds {:.4g} mm",
                  more * result.deflection / kMilli,
                  more > 1.01 ? " in second order" : "", limit / kMilli)};
}

}  // namespace

// A limit may tell where another cannot: a part fails by any of them.
void judge(const part::PartDefinition& part, PartResult& result) {
  const auto take = [&](Judgement judgement) {
    result.verdict = judgement.verdict;
    result.why = std::move(judgement.why);
  };
  std::optional<Judgement> open;
  for (const auto limit :
       {judge_finite_motion, judge_stress, judge_nominal, judge_second_order,
        judge_buckling, judge_deflection}) {
    auto against = limit(part, result);
    if (!against) continue;
    if (against->verdict == part::Verdict::kFail) {
      take(std::move(*against));
      std::string far = beyond_small_displacements(farthest(result));
      if (!far.empty()) result.notes.push_back(std::move(far));
      return;
    }
    if (!open) open = std::move(against);
  }
  if (open) {
    take(std::move(*open));
    return;
  }
  const std::string wide = wide_band(result);
  const std::string out = left_out(part, result);
  const bool both = !wide.empty() && !out.empty();
  take({part::Verdict::kPass, wide + (both ? "; " : "") + out});
}

}  // namespace clevis::assessment
