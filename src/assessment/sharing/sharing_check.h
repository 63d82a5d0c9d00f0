#pragma once

#include "assessment/job/part_job.h"

namespace clevis::assessment {

/// Widens the bands of a part by what its stress and deflection become when
/// reactions that equilibrium leaves open are shared otherwise, and says so.
///
/// A low degree of the model that fits the loads compares the sharings with
/// the one that was checked; the bands grow by the ratio.
void check_sharing(const PartJob& job, PartResult& result);

/// The instants that carry most, of every sharing but the one that was checked.
std::vector<loads::InstantLoad> heaviest_of_others(const PartJob& job,
                                                   const OpenSharing& sharing);

}  // namespace clevis::assessment
