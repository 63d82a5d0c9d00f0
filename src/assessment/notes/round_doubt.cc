#include "assessment/notes/round_doubt.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "assessment/judge/doubt.h"
#include "stress/corners/round_depth.h"

namespace clevis::assessment {
namespace {

// Of a disc's bore under pressure, in cells even from the bore to the rim,
// degree 4 misses 0.3 % two radii deep, 2.1 % four, 7.7 % eight
// (regression.deep_cells).
constexpr double kPerRadius = 0.05;  // over the peak

/// Whether the last degrees hardly changed the peak: then their cells show it.
bool has_settled(const PeakStress& peak) {
  constexpr double kLast = 0.01, kBefore = 0.04;  // over the peak
  const auto& all = peak.sequence;
  if (all.size() < 3) return false;
  const auto change = [&](std::size_t k) {
    const double later = all[all.size() - k].peak;
    return std::abs(later - all[all.size() - k - 1].peak) / later;
  };
  return change(1) < kLast && change(2) < kBefore;
}

/// @return cells' depth over the radius where they are too deep; 0: they are
///   not.
double widen(const PartJob& job, PeakStress& peak) {
  if (!(peak.value > 0.0) || has_settled(peak)) return 0.0;
  const double depth = stress::depth_over_radius(job.mesh, peak.at);
  if (depth <= stress::kResolvedDepth) return 0.0;
  widen_for_cells(peak,
                  kPerRadius * (depth - stress::kResolvedDepth) * peak.value,
                  job.tolerance);
  return depth;
}

}  // namespace

void add_round_doubt(const PartJob& job, PartResult& result) {
  double depth = widen(job, result.peak);
  if (result.peak_outside) {
    depth = std::max(depth, widen(job, *result.peak_outside));
  }
  if (depth == 0.0) return;
  result.notes.push_back(fmt::format(
      "cells at the peak reach {:.3g} radii of the hollow face into the part, "
      "and stress there falls within one: mesh finer there",
      depth));
}

}  // namespace clevis::assessment
