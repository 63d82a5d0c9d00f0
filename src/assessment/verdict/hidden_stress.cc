#include "assessment/verdict/hidden_stress.h"

#include <algorithm>

#include <fmt/format.h>

namespace clevis::assessment {
namespace {

constexpr double kMega = 1e6;

/// Of zones whose section is not known.
std::string without(const std::string& zones) {
  return fmt::format(
      "WITHOUT {}: the nominal stress there may be higher than what is judged, "
      "and no formula of beam theory applies that would say so",
      zones);
}

}  // namespace

std::string governing_zones(const PartResult& result,
                            std::optional<bool> has_section) {
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

bool leaves_zones_out(const part::PartDefinition& part,
                      const PartResult& result) {
  return part.limits.exclude_singular_zones &&
         &judged_peak(result) != &result.peak;
}

std::optional<NominalStress> largest_nominal(const PartResult& result) {
  std::optional<NominalStress> largest;
  if (result.beam.is_section && result.beam.peak_stress) {
    const double stress = *result.beam.peak_stress;
    largest = {stress, stress, stress, result.beam.governing};
  }
  const std::optional<SupportStress>& held = result.held;
  if (!held || (largest && held->band_high <= largest->high)) return largest;
  return NominalStress{
      held->band_low, held->value, held->band_high,
      fmt::format("section {}, {}", held->section, held->label)};
}

double governing_stress(const part::PartDefinition& part,
                        const PartResult& result) {
  const double peak = judged_peak(result).value;
  if (!leaves_zones_out(part, result)) return peak;
  const std::optional<NominalStress> nominal = largest_nominal(result);
  return nominal ? std::max(peak, nominal->value) : peak;
}

std::string left_out(const part::PartDefinition& part,
                     const PartResult& result) {
  if (!leaves_zones_out(part, result)) return "";
  const std::optional<NominalStress> nominal = largest_nominal(result);
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

}  // namespace clevis::assessment
