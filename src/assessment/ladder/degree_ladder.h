#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assessment/job/part_job.h"
#include "assessment/ladder/deflection_band.h"
#include "assessment/ladder/zone_tracker.h"
#include "assessment/models/fe_model.h"
#include "assessment/models/level.h"
#include "assessment/places/nearby_peak.h"
#include "stress/peaks/peak_band.h"

namespace clevis::assessment {

/// Result of climbing the degrees of a model: the last degree, all
/// instants solved, and the values of all degrees.
template <int dim>
struct DegreeLadder {
  explicit DegreeLadder(const PartJob& job, const mesh::PartMesh<dim>& mesh)
      : zones(job, mesh) {}

  ZoneTracker<dim> zones;
  Level<dim> level;
  std::vector<SequenceMember> sequence;
  std::vector<std::vector<stress::PointValue>> probes;  ///< per degree
  std::vector<std::optional<SupportStress>> held;       ///< per degree
  DeflectionWatch<dim> deflections;
  stress::Band band;
  stress::Band outer_band;  ///< away from zones; only if one governs
  /// Between instants, and of those whose loads are not exact, of the judged
  /// peak [Pa].
  double time_error{};
  double jump{};  ///< between cells that meet near the judged peak [Pa]
  /// Of the judged band, where finer solutions nearby gave it.
  std::optional<NearbyPeak> nearby;
  /// Two degrees and finer solutions nearby were enough for the tolerance.
  bool two_are_enough = false;
  /// Why the degrees ended before the highest; empty: they did not.
  std::string ended_by = {};
};

}  // namespace clevis::assessment
