#pragma once

#include "assessment/job/part_job.h"

namespace clevis::assessment {

/// Vibration of a part under its loads: elements in time where an impact of the
/// mechanism wants them (duration_ratio.h), nothing elsewhere.
///
/// The part floats under the loads that rigid bodies put on it, as in the
/// quasi-static check; modes of the shapes that the loads excite vibrate about
/// that answer. Dynamic over quasi-static peak, both by the same elements,
/// times the checked peak is what the part is judged by. The error is that of
/// degree, number of shapes, samples and what lies between the instants.
/// @pre judge_duration_ratios() was called.
void check_vibration(const PartJob& job, PartResult& result);

}  // namespace clevis::assessment
