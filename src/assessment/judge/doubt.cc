#include "assessment/judge/doubt.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace clevis::assessment {
namespace {

struct Source {
  double ErrorShares::*share;
  const char* name;
  bool is_always_told;
  const char* remedy;
};

constexpr std::array kSources{
    Source{&ErrorShares::mesh, "mesh", true, "mesh finer there"},
    Source{&ErrorShares::model, "model", true,
           "take a higher model (--model 3d)"},
    Source{&ErrorShares::time, "time", false,
           "give more instants (`instants` of [simulation])"},
    Source{&ErrorShares::change_points, "change points", false,
           "stop short of the change point, or give the joints there their "
           "`compliance`"},
    Source{&ErrorShares::sharing, "sharing of reactions", false,
           "give the joints their `compliance`, as the note on them says"},
};

}  // namespace

void widen_for_cells(PeakStress& peak, double amount, double tolerance) {
  peak.band_low = std::max(0.0, peak.band_low - amount);
  peak.band_high += amount;
  peak.discretization_error += amount;
  peak.shares.mesh += amount;
  if (peak.verdict == PeakVerdict::kConverged &&
      peak.discretization_error + peak.model_error > tolerance * peak.value) {
    peak.verdict = PeakVerdict::kNotConverged;
  }
}

std::string doubt_text(const PeakStress& peak) {
  std::string text;
  for (const Source& source : kSources) {
    const double share = peak.shares.*source.share;
    if (share == 0.0 && !source.is_always_told) continue;
    text += fmt::format("{}{:.2g} % {}", text.empty() ? "" : " + ",
                        peak.value > 0.0 ? 100.0 * share / peak.value : 0.0,
                        source.name);
  }
  return text;
}

bool is_of_tolerance(const ErrorShares& shares) {
  return std::max(shares.mesh, shares.model) >=
         std::max({shares.time, shares.change_points, shares.sharing});
}

std::string doubt_remedy(const part::PartDefinition& part,
                         const ErrorShares& shares) {
  const auto* largest =
      std::ranges::max_element(kSources, {}, [&](const Source& source) {
        return shares.*source.share;
      });
  if (largest->share == &ErrorShares::time && !part.series.empty()) {
    return "give more rows, or `interpolation = \"linear\"` where the loads "
           "change evenly between two rows";
  }
  return largest->remedy;
}

}  // namespace clevis::assessment
