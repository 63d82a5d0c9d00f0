#pragma once

#include "assessment/job/part_job.h"
#include "assessment/ladder/degree_ladder.h"

namespace clevis::assessment {

/// Result and fields of a part from the degrees of a model, its own output
/// checked against the reported peak. Model error, beam theory and verdict
/// are the caller's.
/// @param seconds  of the climb.
/// @throws Error F003 if the field's maximum is not the reported peak.
template <int dim>
PartAssessment assess(const PartJob& job, const FeModel<dim>& model,
                      const DegreeLadder<dim>& ladder,
                      const PartSeconds& seconds);

}  // namespace clevis::assessment
