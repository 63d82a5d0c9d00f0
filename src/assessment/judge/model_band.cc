#include "assessment/judge/model_band.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "assessment/judge/doubt.h"
#include "assessment/judge/finite_motion.h"

namespace clevis::assessment {
namespace {

void widen(double tolerance, double model_error, PeakStress& peak) {
  peak.discretization_error =
      std::max(peak.band_high - peak.value, peak.value - peak.band_low);
  peak.model_error = model_error * peak.value;
  // Loads between instants can only raise it.
  peak.shares.mesh = std::max(peak.value - peak.band_low,
                              peak.band_high - peak.value - peak.shares.time -
                                  peak.shares.change_points);
  peak.shares.model = peak.model_error;
  peak.band_low = std::max(0.0, peak.band_low - peak.model_error);
  peak.band_high += peak.model_error;
  const double half_width = peak.discretization_error + peak.model_error;
  if (peak.verdict == PeakVerdict::kConverged && model_error > 0.0 &&
      half_width > tolerance * peak.value) {
    peak.verdict = PeakVerdict::kNotConverged;
  }
}

/// With a singular peak the other's stands outside of the zones.
void keep_singular(const PeakStress& other, PartResult& result) {
  if (other.verdict != PeakVerdict::kSingular ||
      result.peak.verdict == PeakVerdict::kSingular) {
    return;
  }
  result.peak_outside = std::exchange(result.peak, other);
}

void add_checks(const SelfChecks& other, SelfChecks& checks) {
  checks.equilibrium = std::max(checks.equilibrium, other.equilibrium);
  checks.residual = std::max(checks.residual, other.residual);
  checks.energy = std::max(checks.energy, other.energy);
  checks.compression = std::max(checks.compression, other.compression);
}

template <class T>
void append(const std::vector<T>& other, std::vector<T>& all) {
  all.insert(all.end(), other.begin(), other.end());
}

}  // namespace

std::vector<PeakStress*> each_peak(PartResult& result) {
  std::vector<PeakStress*> peaks{&result.peak};
  if (result.peak_outside) peaks.push_back(&*result.peak_outside);
  return peaks;
}

std::optional<SupportStress> larger(const std::optional<SupportStress>& one,
                                    const std::optional<SupportStress>& other) {
  if (!one || !other) return one ? one : other;
  return other->band_high > one->band_high ? other : one;
}

void add_model_error(double tolerance, double model_error, PartResult& result) {
  const bool is_outside = result.peak_outside.has_value();
  widen(tolerance, is_outside ? 0.0 : model_error, result.peak);
  if (is_outside) widen(tolerance, model_error, *result.peak_outside);
  // A model's omission concerns stiffness too, and less so.
  const double rest = model_error * result.deflection;
  result.deflection_low = std::max(0.0, result.deflection_low - rest);
  result.deflection_high += rest;
  const PeakStress& peak = judged_peak(result);
  const std::string end = result.stopped_because.empty()
                              ? "highest degree done"
                              : result.stopped_because;
  result.stopped_because =
      fmt::format("{}: {}, {:.3g} % wanted",
                  peak.verdict != PeakVerdict::kConverged ? end
                  : is_outside ? "within tolerance away from the singular zones"
                               : "within tolerance",
                  doubt_text(peak), 100.0 * tolerance);
}

void add_seconds(const PartSeconds& earlier, PartSeconds& seconds) {
  seconds.choose += earlier.choose;
  seconds.assemble += earlier.assemble;
  seconds.factor += earlier.factor;
  seconds.solve += earlier.solve;
  seconds.recover += earlier.recover;
}

PartAssessment join(PartAssessment first, PartAssessment second) {
  if (judged_peak(second.result).band_high >
      judged_peak(first.result).band_high) {
    std::swap(first, second);
  }
  PartResult& result = first.result;
  const PartResult& other = second.result;
  keep_singular(other.peak, result);
  append(other.singular_zones, result.singular_zones);
  append(other.probes, result.probes);
  append(second.fields.history, first.fields.history);
  add_checks(other.self_checks, result.self_checks);
  add_seconds(other.seconds, result.seconds);
  result.load_columns += other.load_columns;
  result.held = larger(result.held, other.held);
  result.strain_energy = std::max(result.strain_energy, other.strain_energy);
  result.finite_motion = farther(result.finite_motion, other.finite_motion);
  result.deflection_high =
      std::max(result.deflection_high, other.deflection_high);
  if (other.deflection > result.deflection) {
    result.deflection = other.deflection;
    result.deflection_low = other.deflection_low;
    result.deflection_at = other.deflection_at;
    result.deflection_instant = other.deflection_instant;
    result.deflection_label = other.deflection_label;
    result.deflection_set = other.deflection_set;
  }
  return first;
}

}  // namespace clevis::assessment
