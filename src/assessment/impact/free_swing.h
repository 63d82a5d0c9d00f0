#pragma once

#include <vector>

#include "assessment/job/part_job.h"
#include "elasticity/problem/displacement_basis.h"
#include "stress/zones/singular_zone.h"

namespace clevis::assessment {

/// What a swing comes to at the most, whenever.
struct FreeSwing {
  double stress{};      ///< von Mises outside the zones [Pa]
  double deflection{};  ///< [m]
};

/// The largest over the points of the sum of the shapes' amplitudes. Without
/// damping each goes on with its own, and no meeting of their phases stresses
/// a point more, for von Mises' stress is a norm: a bound, which frequencies
/// without a common measure come near to in the end.
/// @param basis  its columns are modes, its coefficients their course.
/// @param from   the first sample without a force.
template <int dim>
FreeSwing largest_swing(const elasticity::DisplacementBasis<dim>& basis,
                        const part::Material& material,
                        const std::vector<stress::SingularZone>& zones,
                        int from);

}  // namespace clevis::assessment
