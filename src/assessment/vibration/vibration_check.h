#pragma once

#include <vector>

#include "assessment/job/part_job.h"
#include "assessment/stretches/held_stretches.h"

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

}  // namespace clevis::assessment
