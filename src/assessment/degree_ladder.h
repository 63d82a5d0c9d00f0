#pragma once

#include <optional>
#include <vector>

#include "assessment/deflection_band.h"
#include "assessment/level.h"
#include "assessment/nearby_peak.h"
#include "assessment/part_check.h"
#include "assessment/rung.h"
#include "assessment/zone_watch.h"
#include "stress/peak_band.h"

namespace clevis::assessment {

/// What climbing the degrees of a rung has left: the last degree, all
/// instants solved, and the values of all degrees.
template <int dim>
struct DegreeLadder {
  explicit DegreeLadder(const PartJob& job, const mesh::PartMesh<dim>& mesh)
      : zones(job, mesh) {}

  ZoneWatch<dim> zones;
  Level<dim> level;
  std::vector<SequenceMember> sequence;
  std::vector<std::vector<stress::PointValue>> probes;  ///< per degree
  std::vector<HeldStress> held;                         ///< per degree
  DeflectionWatch deflections;
  stress::Band band;
  stress::Band outer_band;  ///< away from zones; only if one governs
  double time_error{};      ///< between instants, of the judged peak [Pa]
  double jump{};  ///< between cells that meet near the judged peak [Pa]
  /// Of the judged band, where finer solutions nearby gave it.
  std::optional<NearbyPeak> nearby;
};

/// Solves degree after degree until the peak is within the tolerance less the
/// rung's model error.
/// @param job  outlives the result.
/// @param governing  instants that the first degrees are content with; the
///   last is solved for all, and if the peak is at none of these, so are the
///   first. Empty: all instants with every degree.
/// @param seconds  the stages' times are added here.
/// @throws Error as solve_level.
template <int dim>
DegreeLadder<dim> climb_degrees(const PartJob& job,
                                const mesh::PartMesh<dim>& mesh,
                                const Rung<dim>& rung,
                                const std::vector<LoadSet>& governing,
                                PartSeconds& seconds);

}  // namespace clevis::assessment
