#pragma once

#include <optional>
#include <vector>

#include "assessment/job/part_job.h"

namespace clevis::assessment {

/// The blows on a part, in time.
struct CheckedBlows {
  std::vector<ImpactResult> impacts;
  /// Of the blows that may stress or deflect the part most; empty: none.
  std::optional<PartAssessment> assessment;
  std::vector<LoadSet> at_rest;  ///< what stresses the part as much, each
};

/// Computes the blows by all models and climbs the degrees with those that may
/// govern: plates struck in their plane by plane stress, else in 3-D.
/// @throws Error F005 for a --model that has no answer in time; of
///   solve_strike().
CheckedBlows check_blows(const PartJob& job);

/// The static loads that stress the part as its blows do, as load sets: for
/// models that know no time.
/// @throws Error as check_blows().
void add_blows_at_rest(PartJob& job);

/// Puts the blows into the part's result.
void finish_impacts(std::vector<ImpactResult> impacts, PartResult& result);

}  // namespace clevis::assessment
