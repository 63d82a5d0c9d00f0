#pragma once

#include <string>
#include <vector>

#include "elasticity/problem/displacement_basis.h"
#include "loads/history/load_history.h"
#include "loads/holds/holding_groups.h"

namespace clevis::stress {

/// Of a free part that a slide holds: its displacements refer to what the
/// counterpart touches of the wall at each instant, not to all of it. The basis
/// gets the rigid motions for that. Between instants whose mean motions change
/// evenly with the place of the slide these are interpolated, to 3e-4 of the
/// mean displacement.
/// @param groups  of the seats that hold, as of remove_rigid_motion().
/// @return whether it is such a part.
template <int dim>
bool refer_to_touched(const loads::LoadHistory& history,
                      const std::vector<std::string>& groups,
                      elasticity::DisplacementBasis<dim>& basis);

/// Refers the displacements of a free part to what holds it at each instant:
/// what a slide's counterpart touches, else the hold of the instant.
/// @param hold  at the history's hold_time.
template <int dim>
void refer_to_holds(const loads::LoadHistory& history,
                    const loads::PartHold& hold,
                    elasticity::DisplacementBasis<dim>& basis);

}  // namespace clevis::stress
