#pragma once

#include <vector>

#include "assessment/ladder/degree_ladder.h"

namespace clevis::assessment {

/// From this tolerance on two degrees of a solid may be enough, for the peak
/// and for buckling [1].
inline constexpr double kWideTolerance = 0.03;

/// Solves degree after degree until the peak is within the tolerance less the
/// model's error.
/// @param job  outlives the result.
/// @param governing  instants that the first degrees are content with; the
///   last is solved for all, and if the peak is at none of these, so are the
///   first. Empty: all instants with every degree.
/// @param seconds  the stages' times are added here.
/// @throws Error as solve_level.
template <int dim>
DegreeLadder<dim> climb_degrees(const PartJob& job, const FeModel<dim>& model,
                                const std::vector<LoadSet>& governing,
                                PartSeconds& seconds);

}  // namespace clevis::assessment
