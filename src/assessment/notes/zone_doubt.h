#pragma once

#include "assessment/job/part_job.h"
#include "assessment/job/part_result.h"

namespace clevis::assessment {

/// Widens the band of a peak where a slide's counterpart touches less than a
/// cell of its wall: what presses on so little of a cell is not in its shapes.
void add_zone_doubt(const PartJob& job, PartResult& result);

}  // namespace clevis::assessment
