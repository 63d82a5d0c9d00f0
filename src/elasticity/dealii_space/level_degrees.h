#pragma once

#include <vector>

namespace clevis::elasticity {

/// Equations of degree 1 that are factored; more are left to algebraic
/// multigrid.
inline constexpr double kMostFactored = 1e5;

/// Equations of degree 2 that are factored: their factor is the larger, and is
/// gone through in every cycle.
inline constexpr double kMostOfDegree2 = 1e4;

/// Degrees of the levels, from that of the solution down to one that PETSc
/// solves: 2 while it has few equations, else 1.
/// @param nodes  of the discretisation.
std::vector<int> level_degrees(int degree, int dim, double nodes);

}  // namespace clevis::elasticity
