#include "assessment/verdict/governing_peak.h"

#include <algorithm>
#include <cmath>

namespace clevis::assessment {

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

double allowed_stress(const part::PartDefinition& part) {
  return part.material.yield_strength / part.limits.safety_factor.value_or(1.0);
}

double reaches_wanted(const PartResult& result) {
  const bool beside_zone = &judged_peak(result) != &result.peak;
  return beside_zone ? 5.0 : 2.0;
}

bool rise_decides(const part::PartDefinition& part, const PartResult& result,
                  double rise) {
  const PeakStress peak = governing_peak(result);
  const double stress =
      std::max(peak.value, peak.band_high) / allowed_stress(part);
  const double deflection =
      std::max(result.deflection, result.deflection_high) /
      part.limits.deflection.value_or(HUGE_VAL);
  const double used = std::max(stress, deflection);
  return used <= 1.0 && rise * used > 1.0;
}

Swing largest_swing(const PartResult& result) {
  Swing largest;
  for (const Swing& swing : result.swings) {
    largest.stress = std::max(largest.stress, swing.stress);
    largest.deflection = std::max(largest.deflection, swing.deflection);
  }
  return largest;
}

double admitted_peak(const part::PartDefinition& part,
                     const PartResult& result) {
  const PeakStress peak = governing_peak(result);
  const double allowed = allowed_stress(part);
  if (!(peak.value > 0.0) || peak.band_high > allowed) return HUGE_VAL;
  const double reaches =
      peak.verdict == PeakVerdict::kConverged ? 1.0 : reaches_wanted(result);
  return allowed / (1.0 + reaches * (peak.band_high - peak.value) / peak.value);
}

double admitted_deflection(const part::PartDefinition& part,
                           const PartResult& result) {
  if (!part.limits.deflection || !(result.deflection > 0.0)) return HUGE_VAL;
  const double high = std::max(result.deflection_high, result.deflection);
  if (high > *part.limits.deflection) return HUGE_VAL;
  return *part.limits.deflection * result.deflection / high;
}

}  // namespace clevis::assessment
