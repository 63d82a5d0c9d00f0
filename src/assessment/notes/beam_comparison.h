#pragma once

#include "assessment/job/part_job.h"

namespace clevis::assessment {

/// Beam and lug theory from the loads that the FE took, beside its result.
/// @param result  with its peak.
BeamComparison compare_with_beam(const PartJob& job, const PartResult& result);

}  // namespace clevis::assessment
