#pragma once

#include "elasticity/problem/displacement_basis.h"
#include "elasticity/problem/elastic_problem.h"

namespace clevis::elasticity {

/// One factorisation, the load history compressed to its basis, one block
/// solve; large parts iteratively without a matrix (see large_part.h).
/// @param degree  of the displacement, 1…4 (simplices 1…2).
/// @throws Error F001, F002, F003 if a self-check is breached, F004, F007,
/// M003,
///   L002.
template <int dim>
DisplacementBasis<dim> solve(const ElasticProblem<dim>& problem, int degree);

}  // namespace clevis::elasticity
