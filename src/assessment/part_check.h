#pragma once

#include "assessment/job/part_job.h"

namespace clevis::assessment {

/// Solves a part by the models that suit it, the cheapest first. With each the
/// degrees rise until the band of the peak is within the tolerance or the
/// highest is done; the model's error, measured against the next, counts in
/// the band. Beam theory beside it; verdict. Where the peak is not converged on
/// a mesh that may be made finer, the result ends with the peak: no verdict.
/// @throws Error of the modules below.
PartAssessment check_part(const PartJob& job);

}  // namespace clevis::assessment
