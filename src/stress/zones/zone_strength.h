#pragma once

#include <vector>

#include "elasticity/problem/displacement_basis.h"
#include "mesh/derived/graded_mesh.h"
#include "part/material.h"
#include "stress/field/stress_history.h"

namespace clevis::stress {

/// Cells of each ring around one vertex of a graded mesh, outermost first;
/// the cells at the vertex are the last.
std::vector<std::vector<int>> rings_of(const mesh::GradedMesh& graded,
                                       std::size_t vertex);

/// Behaviour of the solved field at a singular vertex.
struct ZoneStrength {
  /// λ from the energies of the rings; 1 where the stress is even.
  double exponent = 1.0;
  double innermost{};  ///< largest von Mises next to the vertex's cells [Pa]
};

/// The strain energy of ring k, q^k as large as the first, goes like q^(2λk):
/// the exponent is fitted over the inner half of the rings but the last,
/// whose neighbours hold the vertex itself.
/// @param rings  at least five.
template <int dim>
ZoneStrength zone_strength(const elasticity::DisplacementBasis<dim>& basis,
                           const part::Material& material,
                           const StressHistory& history,
                           const std::vector<std::vector<int>>& rings);

}  // namespace clevis::stress
