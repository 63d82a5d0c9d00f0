#pragma once

#include "elasticity/problem/displacement_basis.h"
#include "part/material.h"

namespace clevis::stress {

/// A field by the fewest columns that make up its stress at the corners of
/// cells to 1e-4: to look where the field is large at little cost. Without
/// strain energy.
template <int dim>
elasticity::DisplacementBasis<dim> reduced_field(
    const elasticity::DisplacementBasis<dim>& basis,
    const part::Material& material);

}  // namespace clevis::stress
