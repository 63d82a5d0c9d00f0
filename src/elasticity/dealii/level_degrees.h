#pragma once

#include <vector>

namespace clevis::elasticity {

/// Equations that are factored at once; more are left to a lower degree or to
/// algebraic multigrid.
inline constexpr double kMostFactored = 1e5;

/// Degrees of the levels, from that of the solution down to one that PETSc
/// solves: 2 while it has few equations, else 1.
/// @param nodes  of the discretisation.
std::vector<int> level_degrees(int degree, int dim, double nodes);

}  // namespace clevis::elasticity
