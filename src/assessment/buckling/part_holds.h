#pragma once

#include <vector>

#include "assessment/job/part_job.h"
#include "elasticity/buckling/buckling_problem.h"

namespace clevis::assessment {

/// Ways in which a load set's part is held as a whole at instants of a history:
/// loads::holding_groups(), and of slides what they touch of their walls, at
/// sixteen places of their way and at both its ends, where little holds it; at
/// each as the instant with the largest forces has it. All of a slide's wall
/// holds where it is not known what is touched. Where groups do not hold alone
/// (loads::hold_at), all that the mechanism holds does, at sixteen instants.
/// Of more conditions than balance needs as many count, unless all are to hold.
/// @param history  of the set's, or of a sharing of it: a motion first, then
///   cases.
std::vector<elasticity::HoldingSeats> part_holds(
    const LoadSet& set, const loads::LoadHistory& history,
    bool with_all = false);

/// Whether the mechanism holds a load set's part more often than balance needs.
bool is_held_redundantly(const LoadSet& set);

}  // namespace clevis::assessment
