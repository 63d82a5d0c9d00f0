#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "assessment/job/part_job.h"
#include "assessment/stretches/held_stretches.h"
#include "assessment/stretches/vibration_times.h"

namespace clevis::assessment {

/// First period of what the loads excite, where their vibration was computed;
/// else of all that the part does: a plate that they bend in its plane may
/// swing slower across it, and does not [s].
std::optional<double> first_excited(const PartResult& result);

/// Largest answer of a mode without damping to a half-sine pulse over the
/// answer to its largest value at rest, by the pulse's duration over the
/// mode's period [1].
double half_sine_amplification(double duration_over_period);

/// The same of a pulse whose force rises sooner than it falls: at least that of
/// a force that rises evenly and stays, 1 + T/(π t_rise), at most 2
/// [1].
double pulse_amplification(double duration_over_period,
                           double rise_over_period);

/// Puts each impact's duration over the part's first period into the result,
/// and the change of the loads that excites it most; tells when the loads drive
/// vibration that counts. None: those of the instants suffice.
/// @param set  of the job; the first has the mechanism's impacts.
std::vector<VibrationWindow> judge_load_pace(const PartJob& job,
                                             std::size_t set, HeldMotions& held,
                                             PartResult& result);

/// Refers durations to the first period that the loads excite.
/// @pre the vibration has been checked.
void refer_to_vibration(const PartJob& job, PartResult& result);

}  // namespace clevis::assessment
