#pragma once

#include "assessment/job/part_job.h"

namespace clevis::assessment {

/// Widens the band of a peak of a solid that stands at an edge where shear ends
/// by what that may change, and says so. Where the surface is smooth there the
/// edge is a singular zone.
/// @param fields  of the same climb.
void add_shear_doubt(const PartJob& job, const PartFields& fields,
                     PartResult& result);

}  // namespace clevis::assessment
