#pragma once

#include "assessment/job/part_job.h"

namespace clevis::assessment {

/// Assumptions of the cases of a part: reactions of the pins that hold
/// it, loads that its inertia took up.
void note_cases(const PartJob& job, PartResult& result);

}  // namespace clevis::assessment
