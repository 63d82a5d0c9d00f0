#pragma once

#include <vector>

#include "assessment/job/part_job.h"
#include "assessment/vibration/held_stretches.h"

namespace clevis::assessment {

/// Vibration of a part under its loads: elements in time where these change so
/// fast that they excite it (load_pace.h), nothing elsewhere; and the row of
/// each impact (duration_ratio.h).
///
/// The part floats under the loads that rigid bodies put on it, as in the
/// quasi-static check; modes of the shapes that the loads excite vibrate about
/// that answer. Dynamic over quasi-static peak, both by the same elements,
/// times the checked peak is what the part is judged by. The error is that of
/// degree, number of shapes, samples and what lies between the instants.
/// @param rows  of the check at rest.
void check_vibration(const PartJob& job, const std::vector<InstantRow>& rows,
                     HeldMotions& held, PartResult& result);

/// Doubts the vibration of a part whose first frequency is moved, by its own
/// inertia as it turns or by what presses or pulls it, to where its loads make
/// it swing farther: shapes are those at rest.
/// @param stiffening  of BucklingCheck.
/// @pre vibration and buckling are checked.
void doubt_moved_frequencies(const PartJob& job,
                             const std::vector<double>& stiffening,
                             PartResult& result);

/// Doubts it where bodies that spin on the part move its frequencies to those
/// of its loads: their gyroscopic moment is not in the vibration.
/// @pre vibration is checked.
void doubt_spun_frequencies(const PartJob& job, HeldMotions& held,
                            PartResult& result);

}  // namespace clevis::assessment
