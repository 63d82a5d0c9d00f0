#pragma once

#include "elasticity/problem/displacement_basis.h"
#include "part/material.h"
#include "stress/field/stress_history.h"

namespace clevis::stress {

/// Largest von Mises stress of the field between the lattice points too [Pa]:
/// in the cells whose largest lattice value is within 5 % of the peak (the
/// sixteen highest), at the instants of those values, the surroundings of that
/// point are looked at four times, each time twice as close. Never less than
/// the lattice's peak.
template <int dim>
double field_maximum(const elasticity::DisplacementBasis<dim>& basis,
                     const part::Material& material,
                     const StressHistory& history);

}  // namespace clevis::stress
