#pragma once

#include "assessment/job/part_job.h"
#include "assessment/job/part_result.h"

namespace clevis::assessment {

/// Tells where loads that take some of a part's stiffness (those of its
/// buckling) pulse so that any small swing grows: parametric resonance, which
/// no answer to loads has. Each component of the loads counts as if it alone
/// took that stiffness.
/// @pre vibration and buckling have been checked.
void doubt_pulsing_loads(const PartJob& job, PartResult& result);

}  // namespace clevis::assessment
