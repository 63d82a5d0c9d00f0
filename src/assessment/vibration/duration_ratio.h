#pragma once

#include "assessment/job/part_job.h"

namespace clevis::assessment {

/// Largest answer of a mode without damping to a half-sine pulse over the
/// answer to its largest value at rest, by the pulse's duration over the
/// mode's period [1].
double half_sine_amplification(double duration_over_period);

/// The same of a pulse whose force rises sooner than it falls: at least that of
/// a force that rises evenly and stays, 1 + T/(π t_rise), at most 2
/// [1].
double pulse_amplification(double duration_over_period,
                           double rise_over_period);

/// Whether the loads of the instants may be exceeded: the force neither rises
/// and falls slowly nor is over before the part gives way or a wave has run
/// along it.
bool wants_elements_in_time(const DurationRatio& rated);

/// Judges each impact of the mechanism by its duration over the part's first
/// period, free or held; and the jump of its loads after which a mode may swing
/// farthest beyond those of all instants.
void judge_duration_ratios(const PartJob& job, PartResult& result);

}  // namespace clevis::assessment
