#pragma once

#include "assessment/job/part_job.h"

namespace clevis::assessment {

/// Widens the band of a peak that stands on flat facets of a curve by what the
/// curve behind them may make of it, and says so.
/// @param fields  of the same climb.
void add_facet_doubt(const PartJob& job, const PartFields& fields,
                     PartResult& result);

}  // namespace clevis::assessment
