#pragma once

#include <vector>

#include "assessment/job/part_job.h"

namespace clevis::assessment {

/// Second order of a part that its loads bend further as they displace it: of
/// load sets of a part that buckles below ten times its loads (first order is
/// enough above: EN 1993-1-1, 5.2.1 (3)), and at instants at which it spins
/// faster than a tenth of its lowest frequency. Each instant that may hold the
/// largest stress or displacement is solved for; of a motion too many to solve
/// all a bound holds those that are left. Where the part turns round again and
/// again at one speed, what its loads have in common in its frame moves on with
/// it, and the rest, which stands still in space, is added as it is.
/// What cannot be computed (memory, supports that hold a plate in its plane
/// only) is bounded by the buckling factor.
/// @param rows  of the check at rest.
/// @pre `result` has its peak, its buckling and its vibration.
/// @throws Error of elasticity::SecondOrderPart but F001, F002, F004, F007,
///   M005.
void check_second_order(const PartJob& job, const std::vector<InstantRow>& rows,
                        PartResult& result);

}  // namespace clevis::assessment
