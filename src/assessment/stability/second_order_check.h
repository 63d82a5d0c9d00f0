#pragma once

#include <vector>

#include "assessment/job/part_job.h"
#include "assessment/stability/buckling_model.h"
#include "assessment/vibration/held_stretches.h"

namespace clevis::assessment {

/// Second order of a part that its loads bend further as they displace it: of
/// load sets of a part that buckles below ten times its loads (first order is
/// enough above: EN 1993-1-1, 5.2.1 (3)), and at instants at which it spins
/// faster than a tenth of its lowest frequency. Of each set the instant
/// that may rise to most is solved for, and those that may decide a limit with
/// what lies between them and the next, some dozens at most; the rest is
/// bounded. K_G counts as the band of the buckling factor has it at most. Of a
/// part whose spin counts it is looked at, too, whether it bears as much more
/// of its loads, with their spin, as the limit of buckling wants. Vibration
/// counts as so much more load. Where the part turns on at one speed, only what
/// its loads have in common in its frame is spun: the rest stands still in
/// space. What cannot be computed (memory) is bounded by the buckling factor;
/// of fast spin it is a failure.
/// @param rows  of the check at rest.
/// @param of_lowest_degree  buckling factor by the model's [1]; 0: not known.
/// @pre `result` has its peak, its buckling and its vibration.
/// @throws Error of elasticity::StressedPart but F001, F002, F004, F007,
///   M005.
void check_second_order(const PartJob& job, const std::vector<InstantRow>& rows,
                        double of_lowest_degree, HeldMotions& held,
                        BucklingModel& model, PartResult& result);

}  // namespace clevis::assessment
