#pragma once

#include <string>

#include "elasticity/fe_space/discretization.h"
#include "part/material.h"

namespace clevis::elasticity {

/// Whether MultigridSolver can take the part: hexahedra of one degree, 2…4,
/// and ν <= 0.45 (towards ½ it converges ever more slowly).
bool suits_multigrid(const Discretization<3>& discretization,
                     const part::Material& material);

/// Effort of a direct solve.
struct DirectCost {
  double flops{};  ///< of all factors
  double bytes{};  ///< of all factors, kept together
};

/// Time of a solve [s] on one core of 2020: only ratios matter.
/// @param flops  of all factors.
double factor_seconds(double flops);
/// @param columns  right-hand sides of all classes together.
double multigrid_seconds(double dofs, double columns);

/// Whether it should: where the factors do not fit into memory, and where
/// they would take clearly longer and the cells are not too anisotropic.
/// @param columns  right-hand sides of all classes together.
/// @param memory  of the machine [bytes].
bool prefers_multigrid(const Discretization<3>& discretization,
                       const part::Material& material, const DirectCost& direct,
                       double columns, double memory);

/// Longest over shortest side that 95 % of the tensor cells do not exceed [1].
template <int dim>
double cell_aspect(const Discretization<dim>& discretization);

}  // namespace clevis::elasticity
