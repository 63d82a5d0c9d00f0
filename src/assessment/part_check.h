#pragma once

#include "assessment/job/part_job.h"

namespace clevis::assessment {

/// Climbs the ladder with a part: plane stress where it is a plate loaded in
/// its plane, terms through the thickness where it is a plate loaded on its
/// sides, 3-D. On each rung degrees rise until the band of the peak is within
/// the tolerance or the highest is done; the model's error, measured against
/// the rung above, counts in the band. Beam theory beside it; verdict.
/// @throws Error of the modules below.
PartAssessment check_part(const PartJob& job);

}  // namespace clevis::assessment
