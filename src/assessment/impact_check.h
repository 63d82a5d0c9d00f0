#pragma once

#include "assessment/part_check.h"

namespace clevis::assessment {

/// Computes the blows on a part in time and gives the job, for each, the static
/// load that stresses the part as much: static elements times the dynamic
/// factor, so that the check of that load is the check of the blow. The factor
/// compares the largest stress of both outside the singular zones.
/// @return one per blow; finish_impacts() completes them.
/// @throws Error of solve_strike().
std::vector<ImpactResult> compute_impacts(PartJob& job);

/// Stress, band and safety of the blows from the checked part, whose band gets
/// the error of the dynamic factors too; the rows of the other models beside.
void finish_impacts(const PartJob& job, std::vector<ImpactResult> impacts,
                    PartResult& result);

}  // namespace clevis::assessment
