#pragma once

#include <vector>

#include "elasticity/solid/neighbourhood.h"
#include "part/material.h"
#include "stress/field/stress_history.h"

namespace clevis::stress {

/// Cells in which the exact peak may stand: those whose highest lattice value
/// is within a tenth of the peak, the four highest of them, highest first.
std::vector<int> peak_cells(const StressHistory& history);

/// Largest von Mises stress that a field of higher degree has in some of its
/// cells [Pa].
/// @param cells  of the mesh, as handed to elasticity::enrich.
template <int dim>
double enriched_peak(const elasticity::Enriched<dim>& enriched,
                     const std::vector<int>& cells,
                     const part::Material& material, int subdivisions);

}  // namespace clevis::stress
