#include "assessment/judge/verdict.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "assessment/judge/doubt.h"
#include "assessment/judge/finite_motion.h"
#include "part/buckling_limit.h"
#include "part/verdict.h"

namespace clevis::assessment {
namespace {

constexpr double kMega = 1e6;
constexpr double kMilli = 1e-3;
constexpr double kLargestConcentration = 5.0;  // of holes and fillets

void set(PartResult& result, part::Verdict verdict, std::string why) {
  result.verdict = verdict;
  result.why = std::move(why);
}

std::string unsettled_remedy(const part::PartDefinition& part,
                             const PeakStress& peak) {
  if (peak.verdict == PeakVerdict::kSingular) {
    return "round the corner, or support the part without a sharp edge";
  }
  return fmt::format("in doubt by {}: {}", doubt_text(peak),
                     doubt_remedy(part, peak.shares));
}

/// Whether a peak that is not converged lies within the limit all the same:
/// what is wider than the tolerance is an estimate from degrees that are far
/// from settled, and has to hold with twice its reach; beside a singular zone,
/// whose own cells may be as large as the zone, with five times.
double reaches_wanted(bool beside_zone) {
  return beside_zone ? 5.0 : 2.0;
}

bool is_clearly_within(const PeakStress& peak, bool beside_zone,
                       double allowed) {
  const double safety = reaches_wanted(beside_zone);
  return peak.verdict == PeakVerdict::kNotConverged && peak.has_band &&
         peak.value + safety * (peak.band_high - peak.value) <= allowed;
}

/// "edge of root at (0, 0) mm and 1 more" of the zones that govern, of those
/// only that are of this kind.
std::string governing_zones(const PartResult& result,
                            std::optional<bool> has_section = {}) {
  std::string first;
  int more = 0;
  for (const ZoneResult& zone : result.singular_zones) {
    if (!zone.governs ||
        zone.has_section != has_section.value_or(zone.has_section))
      continue;
    if (first.empty()) {
      first = zone.name;
    } else {
      ++more;
    }
  }
  return more == 0 ? first : fmt::format("{} and {} more", first, more);
}

/// A part whose stress is unbounded somewhere cannot pass unless the user
/// leaves such zones out; it can fail by its stress elsewhere.
bool is_singular_only(const part::PartDefinition& part,
                      const PartResult& result, double allowed) {
  return &judged_peak(result) != &result.peak &&
         !part.limits.exclude_singular_zones &&
         result.peak_outside->band_low <= allowed;
}

/// The peak that decides: with vibration where that was computed.
PeakStress governing_peak(const PartResult& result) {
  PeakStress peak = judged_peak(result);
  if (!result.vibration.governs) return peak;
  peak.value = result.vibration.peak;
  peak.band_low = result.vibration.band_low;
  peak.band_high = result.vibration.band_high;
  peak.group = result.vibration.group;
  const VibrationResult& vibration = result.vibration;
  peak.shares.mesh +=
      (vibration.degree_error + vibration.shape_error) * vibration.peak;
  peak.shares.time +=
      (vibration.sampling_error + vibration.path_error) * vibration.peak;
  return peak;
}

bool judge_stress(const part::PartDefinition& part, PartResult& result) {
  const PeakStress peak = governing_peak(result);
  const double wanted = part.limits.safety_factor.value_or(1.0);
  const double allowed = part.material.yield_strength / wanted;
  const bool is_decided =
      peak.verdict == PeakVerdict::kConverged ||
      (peak.verdict == PeakVerdict::kNotConverged && peak.band_low > allowed) ||
      is_clearly_within(peak, &judged_peak(result) != &result.peak, allowed);
  if (peak.value == 0.0 && result.peak.value > 0.0) {
    set(result, part::Verdict::kNotJudged,
        fmt::format("the singular zones cover the whole part ({}): mesh finer",
                    governing_zones(result)));
    return false;
  }
  if (peak.value == 0.0) {
    set(result, part::Verdict::kNotJudged,
        "nothing stresses the part: its loads cancel, or act on held surfaces "
        "only");
    return false;
  }
  if (is_singular_only(part, result, allowed)) {
    set(result, part::Verdict::kNotJudged,
        fmt::format(
            "stress without bound at {}; elsewhere {:.4g} MPa ({}). Round the "
            "corner or spread the support, or judge without it by limits = {{ "
            "singular_zones = \"exclude\" }}",
            governing_zones(result), peak.value / kMega,
            peak.verdict == PeakVerdict::kConverged ? "converged"
                                                    : "not converged"));
    return false;
  }
  if (!is_decided) {
    set(result, part::Verdict::kNotJudged,
        fmt::format("peak {} at {}: [{:.4g}, {:.4g}] MPa; {}",
                    peak.verdict == PeakVerdict::kSingular
                        ? "singular (grows without bound under refinement)"
                        : "not converged",
                    peak.group, peak.band_low / kMega, peak.band_high / kMega,
                    unsettled_remedy(part, peak)));
    return false;
  }
  const std::string limit =
      part.limits.safety_factor
          ? fmt::format("{:.4g} MPa (safety factor {:.4g})", allowed / kMega,
                        wanted)
          : fmt::format("yield strength {:.4g} MPa", allowed / kMega);
  if (peak.band_low > allowed) {
    set(result, part::Verdict::kFail,
        fmt::format("peak {:.4g} MPa{} exceeds {}", peak.value / kMega,
                    result.vibration.governs ? " with vibration" : "", limit));
    return false;
  }
  if (peak.band_high > allowed) {
    const bool vibrates = result.vibration.governs;
    set(result, part::Verdict::kNotJudged,
        fmt::format("{} lies inside the band of the peak{}, [{:.4g}, {:.4g}] "
                    "MPa: {}",
                    limit, vibrates ? " with vibration" : "",
                    peak.band_low / kMega, peak.band_high / kMega,
                    vibrates ? "give the part its damping, or mesh finer"
                             : "tighten --tolerance, or " +
                                   doubt_remedy(part, peak.shares)));
    return false;
  }
  const VibrationResult& vibration = result.vibration;
  if (!vibration.is_whole()) {
    const bool is_cut = vibration.failure.empty() && vibration.ratio;
    set(result, part::Verdict::kNotJudged,
        fmt::format(
            "its vibration {} ({}), without {} the peak is {:.4g} MPa",
            is_cut ? "is not known to the end" : "could not be computed",
            vibration.failure.empty() ? vibration.not_followed
                                      : vibration.failure,
            is_cut ? "the rest" : "it", peak.value / kMega));
    return false;
  }
  return true;
}

bool leaves_zones_out(const part::PartDefinition& part,
                      const PartResult& result) {
  return part.limits.exclude_singular_zones &&
         &judged_peak(result) != &result.peak;
}

/// The nominal stress of a section that may lie in a zone left out.
struct Nominal {
  double low{}, value{}, high{};  ///< [Pa]
  std::string what;               ///< "section root, impact blow"
};

/// The largest of the held faces' and of beam theory's sections, if one is
/// known. Formulas of lugs are none of a section.
std::optional<Nominal> largest_nominal(const PartResult& result) {
  std::optional<Nominal> largest;
  if (result.beam.is_section && result.beam.peak_stress) {
    const double stress = *result.beam.peak_stress;
    largest = {stress, stress, stress, result.beam.governing};
  }
  const std::optional<SupportStress>& held = result.held;
  if (!held || (largest && held->band_high <= largest->high)) return largest;
  return Nominal{held->band_low, held->value, held->band_high,
                 fmt::format("section {}, {}", held->section, held->label)};
}

/// Over all load sets.
Swing largest_swing(const PartResult& result) {
  Swing largest;
  for (const Swing& swing : result.swings) {
    largest.stress = std::max(largest.stress, swing.stress);
    largest.deflection = std::max(largest.deflection, swing.deflection);
  }
  return largest;
}

/// Where a zone is left out, the nominal stress of the section stands for what
/// it hides: a part is not judged by less.
bool judge_nominal(const part::PartDefinition& part, PartResult& result) {
  if (!leaves_zones_out(part, result)) return true;
  const std::optional<Nominal> nominal = largest_nominal(result);
  const double allowed =
      part.material.yield_strength / part.limits.safety_factor.value_or(1.0);
  if (!nominal) return true;
  const double more = largest_swing(result).stress * result.second_order.stress;
  if (nominal->high <= allowed && more * nominal->high > allowed) {
    set(result, part::Verdict::kNotJudged,
        fmt::format(
            "nominal stress {:.4g} MPa by linear theory at rest ({}), hidden "
            "by the zone left out: {:.4g} times with vibration, {:.4g} times "
            "in second order it may exceed {:.4g} MPa",
            nominal->value / kMega, nominal->what, largest_swing(result).stress,
            result.second_order.stress, allowed / kMega));
    return false;
  }
  if (nominal->high <= allowed) return true;
  const bool fails = nominal->low > allowed;
  set(result, fails ? part::Verdict::kFail : part::Verdict::kNotJudged,
      fmt::format("nominal stress {:.4g} [{:.4g}, {:.4g}] MPa ({}), hidden by "
                  "the zone left out, {} {:.4g} MPa",
                  nominal->value / kMega, nominal->low / kMega,
                  nominal->high / kMega, nominal->what,
                  fails ? "exceeds" : "may exceed", allowed / kMega));
  return false;
}

/// Of zones whose section is not known.
std::string without(const std::string& zones) {
  return fmt::format(
      "WITHOUT {}: the nominal stress there may be higher than what is judged, "
      "and no formula of beam theory applies that would say so",
      zones);
}

/// Of a part that passes though its peak is not converged.
std::string wide_band(const PartResult& result) {
  const PeakStress& peak = judged_peak(result);
  if (peak.verdict != PeakVerdict::kNotConverged) return "";
  return fmt::format(
      "by its band, which lies within the limit as a whole though the peak is "
      "not converged ({})",
      doubt_text(peak));
}

/// Zones that a passing part was not held against.
std::string left_out(const part::PartDefinition& part,
                     const PartResult& result) {
  if (!leaves_zones_out(part, result)) return "";
  const std::optional<Nominal> nominal = largest_nominal(result);
  if (!nominal) return without(governing_zones(result));
  const bool is_held = result.held.has_value();  // not a link of beam theory
  const std::string known = governing_zones(result, is_held);
  const std::string unknown = is_held ? governing_zones(result, false) : "";
  std::string text;
  if (!known.empty()) {
    text = fmt::format(
        "without {}, where the nominal stress ({}) is {:.4g} MPa and the "
        "corner's own is not judged",
        known, nominal->what, nominal->value / kMega);
  }
  if (!unknown.empty()) text += (text.empty() ? "" : "; ") + without(unknown);
  return text;
}

bool judge_euler(double wanted, PartResult& result) {
  if (!result.buckling.euler_fails(wanted)) return true;
  set(result, part::Verdict::kFail,
      fmt::format("buckling: Euler's load is {:.3g} times the compression, "
                  "{:.4g} is wanted",
                  *result.buckling.euler, wanted));
  return false;
}

/// Loads of which vibration makes more buckle the part sooner, if they last.
bool judge_swinging_buckling(double wanted, PartResult& result) {
  const BucklingResult& buckling = result.buckling;
  if (result.swings.empty() || !buckling.factor) return true;
  const double low = buckling.band_low / *buckling.factor;
  for (std::size_t s = 0; s < buckling.of_motions.size(); ++s) {
    const double factor = buckling.of_motions[s];
    const double swing = result.swings[s].largest();
    if (low * factor >= swing * wanted) continue;
    set(result, part::Verdict::kNotJudged,
        fmt::format(
            "buckling: {:.4g} times the loads of its motion at rest, of "
            "which vibration makes {:.4g} times as much; {:.4g} is "
            "wanted",
            factor, swing, wanted));
    return false;
  }
  return true;
}

/// Of a part that passes by linear theory.
bool judge_second_order(const part::PartDefinition& part, PartResult& result) {
  const SecondOrderResult& found = result.second_order;
  if (!found.is_stable) {
    set(result, part::Verdict::kNotJudged,
        fmt::format("its loads and its spin ({}) bend it further and further: "
                    "linear theory has no stress for it",
                    found.label));
    return false;
  }
  if (!found.bears_growth) {
    set(result, part::Verdict::kNotJudged,
        fmt::format("buckling: {:.4g} times the loads of {}, with as much more "
                    "of what its spin makes of them, may be more than it bears",
                    part::wanted_buckling_factor(part.limits), found.label));
    return false;
  }
  const double admitted = admitted_peak(part, result);
  if (!found.failure.empty()) {
    set(result, part::Verdict::kNotJudged,
        "how far its loads bend it further is not known: " + found.failure);
    return false;
  }
  if (std::max(found.peak, found.bound) <= admitted) return true;
  const PeakStress peak = governing_peak(result);
  const double allowed =
      part.material.yield_strength / part.limits.safety_factor.value_or(1.0);
  // The product with vibration is an upper bound: it decides nothing.
  const bool fails = found.least_peak * peak.band_low > allowed * peak.value;
  set(result, fails ? part::Verdict::kFail : part::Verdict::kNotJudged,
      fails ? fmt::format("its loads act on what they displace: {:.4g} MPa "
                          "({:.4g} of linear theory, {}) exceeds {:.4g} MPa",
                          found.peak / kMega, found.stress, found.label,
                          allowed / kMega)
            : fmt::format("its loads act on what they displace: {:.4g} MPa at "
                          "most, {:.4g} MPa are allowed",
                          std::max(found.peak, found.bound) / kMega * allowed /
                              admitted,
                          allowed / kMega));
  return false;
}

/// Of a case that one pin holds: what else may hold it.
std::string free_end(const part::PartDefinition& part,
                     const BucklingResult& buckling) {
  const bool is_held_by_one =
      std::ranges::any_of(part.cases, [&](const auto& load_case) {
        return load_case.name == buckling.label &&
               load_case.held_by_pin.size() == 1 && !load_case.pins.empty();
      });
  if (!is_held_by_one) return "";
  return ". Where its loads act it is free to move sideways: if pins guide it "
         "there, give all forces under `pins` and no `held_by_pin`";
}

bool judge_buckling(const part::PartDefinition& part, PartResult& result) {
  const double wanted = part::wanted_buckling_factor(part.limits);
  const BucklingResult& buckling = result.buckling;
  if (!judge_euler(wanted, result)) return false;
  const bool is_open = !buckling.factor && !buckling.remark.empty();
  // Without a limit of the user's own Euler's strut is enough.
  if (is_open && (part.limits.buckling || !buckling.euler)) {
    set(result, part::Verdict::kNotJudged,
        "the limit of buckling is not held against: " + buckling.remark);
    return false;
  }
  if (!buckling.factor || buckling.band_low >= wanted) {
    return judge_swinging_buckling(wanted, result);
  }
  const bool fails = buckling.band_high < wanted;
  const std::string doubt = fails                  ? ""
                            : buckling.if_all_hold ? ": " + buckling.remark
                                                   : ": mesh finer";
  set(result, fails ? part::Verdict::kFail : part::Verdict::kNotJudged,
      fmt::format("buckling: the part buckles under {:.4g} [{:.4g}, {:.4g}] "
                  "times the loads of {}, {:.4g} is wanted{}{}",
                  *buckling.factor, buckling.band_low, buckling.band_high,
                  buckling.label, wanted, doubt, free_end(part, buckling)));
  return false;
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
bool judge_finite_motion(const part::PartDefinition&, PartResult& result) {
  std::string why = beyond_small_displacements(farthest(result));
  if (why.empty()) return true;
  set(result, part::Verdict::kNotJudged, std::move(why));
  return false;
}

bool judge_deflection(const part::PartDefinition& part, PartResult& result) {
  if (!part.limits.deflection) return true;
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
  if (high <= limit) return true;
  const double low = times_linear(found.least_deflection) * least;
  if (low <= limit) {
    set(result, part::Verdict::kNotJudged,
        fmt::format("{:.4g} mm lies inside the band of the deflection{}, "
                    "[{:.4g}, {:.4g}] mm: mesh finer",
                    limit / kMilli, more > 1.01 ? " in second order" : "",
                    low / kMilli, high / kMilli));
    return false;
  }
  set(result, part::Verdict::kFail,
      fmt::format("deflection {:.4g} mm{} exceeds {:.4g} mm",
                  more * result.deflection / kMilli,
                  more > 1.01 ? " in second order" : "", limit / kMilli));
  return false;
}

}  // namespace

double admitted_peak(const part::PartDefinition& part,
                     const PartResult& result) {
  const PeakStress peak = governing_peak(result);
  const double allowed =
      part.material.yield_strength / part.limits.safety_factor.value_or(1.0);
  if (!(peak.value > 0.0) || peak.band_high > allowed) return HUGE_VAL;
  const bool beside_zone = &judged_peak(result) != &result.peak;
  const double reaches = peak.verdict == PeakVerdict::kConverged
                             ? 1.0
                             : reaches_wanted(beside_zone);
  return allowed / (1.0 + reaches * (peak.band_high - peak.value) / peak.value);
}

double admitted_deflection(const part::PartDefinition& part,
                           const PartResult& result) {
  if (!part.limits.deflection || !(result.deflection > 0.0)) return HUGE_VAL;
  const double high = std::max(result.deflection_high, result.deflection);
  if (high > *part.limits.deflection) return HUGE_VAL;
  return *part.limits.deflection * result.deflection / high;
}

double governing_stress(const part::PartDefinition& part,
                        const PartResult& result) {
  const double peak = judged_peak(result).value;
  if (!leaves_zones_out(part, result)) return peak;
  const std::optional<Nominal> nominal = largest_nominal(result);
  return nominal ? std::max(peak, nominal->value) : peak;
}

// A limit may tell where another cannot: a part fails by any of them.
void judge(const part::PartDefinition& part, PartResult& result) {
  std::string open;
  for (const auto holds :
       {judge_finite_motion, judge_stress, judge_nominal, judge_second_order,
        judge_buckling, judge_deflection}) {
    if (holds(part, result)) continue;
    if (result.verdict == part::Verdict::kFail) {
      std::string far = beyond_small_displacements(farthest(result));
      if (!far.empty()) result.notes.push_back(std::move(far));
      return;
    }
    if (open.empty()) open = result.why;
  }
  if (open.empty()) {
    const std::string wide = wide_band(result);
    const std::string out = left_out(part, result);
    const bool both = !wide.empty() && !out.empty();
    set(result, part::Verdict::kPass, wide + (both ? "; " : "") + out);
  } else {
    set(result, part::Verdict::kNotJudged, open);
  }
}

std::string explain_ratio(const PeakStress& peak, const BeamComparison& beam) {
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
