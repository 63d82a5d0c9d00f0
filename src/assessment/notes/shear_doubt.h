#pragma once

#include "assessment/job/part_job.h"

namespace clevis::assessment {

/// Widens the band of a peak of a solid by what shear that ends at an edge of
/// the part may change: both ways where the peak stands there, upwards where
/// the corner of a loaded face may exceed it; and says so. Where the surface is
/// smooth there the edge is a singular zone.
/// @param fields  of the same climb.
void add_shear_doubt(const PartJob& job, const PartFields& fields,
                     PartResult& result);

}  // namespace clevis::assessment
