#pragma once

#include "assessment/job/part_job.h"

namespace clevis::assessment {

/// Widens the band of a peak at a hollow curved face, as that of a hole, whose
/// cells reach so deep that no degree of theirs shows how its stress falls, and
/// says so.
void add_round_doubt(const PartJob& job, PartResult& result);

}  // namespace clevis::assessment
