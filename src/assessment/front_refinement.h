#pragma once

#include <vector>

#include "assessment/part_result.h"
#include "assessment/struck_run.h"

namespace clevis::assessment {

/// An ideal velocity step, or a contact that asks for more than a hundred
/// shapes: the stress may have no bound, and steps for all equations would take
/// minutes.
template <int dim>
bool is_hard(const StruckRun<dim>& run);

/// The blow with ever more shapes, waves shorter than theirs damped: stress and
/// deflection of each, and whether the stress settles. An ideal step's
/// spring becomes four times as stiff each time.
/// @param ideal_spring  its first [N/m].
/// @throws Error of StruckFace.
template <int dim>
FrontRefinement refine_front(const PartJob& job, const ImpactJob& impact,
                             const std::vector<stress::SingularZone>& zones,
                             int degree, double ideal_spring,
                             StruckFaces<dim>& faces);

}  // namespace clevis::assessment
