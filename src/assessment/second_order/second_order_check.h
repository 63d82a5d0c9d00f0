#pragma once

#include <string>
#include <vector>

#include "assessment/buckling/buckling_model.h"
#include "assessment/job/part_job.h"
#include "assessment/stretches/held_stretches.h"
#include "elasticity/buckling/buckling.h"

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

/// Bounds second order of a part that buckles together with what yields beside
/// it: stress and deflection rise by no more than 1/(1 − 1/λ).
/// @param together  λ at the least [1].
/// @param counted   what is in second order already [1].
/// @param why       where λ is 1 or less.
void bound_by_buckling_together(double together, double counted,
                                const std::string& why, PartResult& result);
/// Of a part on springs of its mechanism: second order is bounded by the factor
/// that both have together [1], less what the mechanism's motion has of it.
/// @pre count_springs() has been called; `result` has its second order, where
///   its seats as held buckle no later than it does on the springs.
void bound_on_springs(const elasticity::BucklingMode::OnSprings& on,
                      PartResult& result);
/// By how much loads near a factor of buckling above 1 bend a part further [1].
double bent_further(double factor);

}  // namespace clevis::assessment
