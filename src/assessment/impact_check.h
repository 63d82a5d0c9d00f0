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

/// Largest answer of a mode without damping to a half-sine pulse over the
/// answer to its largest value at rest, by the pulse's duration over the
/// mode's period.
double half_sine_amplification(double duration_over_period);

/// The same of a pulse whose force rises sooner than it falls: at least that of
/// a force that rises evenly and stays, 1 + T/(π t_rise), at most 2.
double pulse_amplification(double duration_over_period,
                           double rise_over_period);

/// What the impacts of the mechanism ask of a part: the duration of each over
/// the part's first period, free or held.
void judge_paces(const PartJob& job, PartResult& result);

}  // namespace clevis::assessment
