#pragma once

#include "assessment/job/part_job.h"

namespace clevis::assessment {

/// Second order of a part that its loads bend further as they displace it: of
/// one that buckles below ten times its loads (first order is enough above:
/// EN 1993-1-1, 5.2.1 (3)) at the instants of buckling and of the peak, and of
/// one that spins faster than a tenth of its first frequency when it does most.
/// What cannot be computed (memory, supports that hold a plate in its plane
/// only) is left out, and a note says so.
/// @pre `result` has its peak, its buckling and its vibration.
/// @throws Error of elasticity::second_order but F001, F002, F004, F007, M005.
void check_second_order(const PartJob& job, PartResult& result);

}  // namespace clevis::assessment
