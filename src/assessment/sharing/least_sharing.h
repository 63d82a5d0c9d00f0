#pragma once

#include "assessment/job/part_job.h"
#include "assessment/sharing/rough_answers.h"

namespace clevis::assessment {

/// The least stress and the least deflection that any sharing was found to
/// make, by rough_answers() at the instants that stress the part most. What is
/// convex is largest at a corner of all sharings and least anywhere between
/// them: from the one that was checked it is sought towards each corner, again
/// and again from the best.
/// @pre `open` has others.
RoughPeak least_sharing(const PartJob& job, const OpenSharing& open);

}  // namespace clevis::assessment
