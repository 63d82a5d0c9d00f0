#pragma once

#include <optional>
#include <vector>

#include "assessment/job/part_job.h"
#include "assessment/models/level.h"
#include "stress/peaks/peak_band.h"

namespace clevis::assessment {

/// The peak of a solid by finer solutions near every place where it may stand.
struct NearbyPeak {
  stress::Band band;
  int degree{};   ///< of the finest
  double jump{};  ///< between the cells that meet at the peak, as solved [Pa]
  std::size_t set{};
  stress::FieldPoint at;
  int instant{};
  /// Places whose error keeps the band from being within the tolerance, or
  /// nearly does.
  std::vector<OpenPlace> open;
};

/// What a search found.
struct FoundPeak {
  /// Nothing if a neighbourhood cannot be solved for, or the search was left
  /// before the first one was.
  std::optional<NearbyPeak> peak;
  /// Error at the highest place that no degree mends, of its stress [1].
  double lasting_error{};
};

/// Which places are looked at.
enum class PlaceSearch {
  kAll,
  /// Until the band cannot come within the tolerance any more: where the next
  /// degree follows then anyway.
  kWhileItMayConverge
};

/// Looks at the places whose stress by any of the cells that meet there reaches
/// the largest of their means, highest first. Near each the part is solved
/// again one and two degrees higher, and one degree higher with a second layer
/// of cells: the value is the mean of the cells that meet. What degree, layer
/// and cells differ by is its error.
/// @param sets  that the level was solved for.
/// @param pollution  what may come from outside of the neighbourhoods [1].
/// @param histories  of its sets; points below zero do not count.
template <int dim>
FoundPeak nearby_peak(const PartJob& job, const std::vector<LoadSet>& sets,
                      const mesh::PartMesh<dim>& mesh, const Level<dim>& level,
                      const std::vector<stress::StressHistory>& histories,
                      double pollution, double tolerance,
                      PlaceSearch which = PlaceSearch::kAll);

}  // namespace clevis::assessment
