#pragma once

#include <string>

#include "elasticity/discretization.h"
#include "part/material.h"

namespace clevis::elasticity {

/// How the equations are solved.
enum class LinearSolver {
  kAuto,      ///< as prefers_multigrid() says
  kDirect,    ///< sparse Cholesky
  kMultigrid  ///< MultigridSolver; hexahedra of degree 2…4 only
};

/// Whether MultigridSolver can take the part: hexahedra of one degree, 2…4,
/// and ν <= 0.45 (towards ½ it converges ever more slowly).
bool suits_multigrid(const Discretization<3>& discretization,
                     const part::Material& material);

/// Whether it should: where a factor does not fit into memory, and for large
/// parts of not too anisotropic cells.
/// @param factored_dofs  of a part whose factor is as large as those that a
///   direct solve needs.
/// @param memory  of the machine [bytes].
bool prefers_multigrid(const Discretization<3>& discretization,
                       const part::Material& material, double factored_dofs,
                       double memory);

/// Longest over shortest side that 95 % of the hexahedra do not exceed.
double cell_aspect(const Discretization<3>& discretization);

}  // namespace clevis::elasticity
