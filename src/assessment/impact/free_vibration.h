#pragma once

#include <vector>

#include "assessment/job/part_job.h"
#include "elasticity/problem/displacement_basis.h"
#include "stress/zones/singular_zone.h"

namespace clevis::assessment {

/// Bound of a free vibration over all times.
struct FreeVibration {
  double stress{};      ///< von Mises outside the zones [Pa]
  double deflection{};  ///< [m]
};

/// Bound of a free vibration: the sum of the shapes' amplitudes at a point,
/// largest over the points. Amplitudes without damping stay, and von Mises'
/// stress is a norm, so no phases stress a point more. Incommensurable
/// frequencies approach the bound in the end.
/// @param basis  its columns are modes, its coefficients their course.
/// @param from   the first sample without a force.
template <int dim>
FreeVibration largest_free_vibration(
    const elasticity::DisplacementBasis<dim>& basis,
    const part::Material& material,
    const std::vector<stress::SingularZone>& zones, int from);

}  // namespace clevis::assessment
