#pragma once

#include <string>

namespace clevis::elasticity {

/// Memory [bytes] of a nested-dissection Cholesky factor of a mesh with so many
/// degrees of freedom: 11 N^(4/3) entries in 3-D (calibrated on compact
/// bodies; slender ones need less), 8 N log₂ N in the plane.
double factor_bytes(int dim, double dofs);

/// Whether so much fits into a machine's memory [bytes], with room for the
/// rest.
bool holds(double bytes, double available);

/// @param bytes      of the factors.
/// @param available  memory of the machine [bytes].
/// @throws Error F004 if they would not fit, before they are allocated.
void require_memory(double bytes, double dofs, double available,
                    const std::string& place);

/// Memory [bytes] of the iterative solve of a hexahedral mesh without its
/// matrix: the vectors, the metric and the factor of the coarse level.
/// Calibrated with tests/benchmarks/large_parts.
/// @param degree   of the displacement, 2…4.
/// @param coarse   degree of the level that is factored.
/// @param columns  of loads.
double multigrid_bytes(int degree, int coarse, double dofs, double columns);

/// @param available  memory of the machine [bytes].
/// @throws Error F004 if that would not fit.
void require_multigrid_memory(int degree, int coarse, double dofs,
                              double columns, double available,
                              const std::string& place);

/// The same of deal.II's iterative solve, a column after the other.
void require_dealii_memory(double dofs, double available,
                           const std::string& place);

/// Memory that this process may use [bytes]: the machine's, or less by a limit
/// on its address space (ulimit -v) or on its group (containers).
double usable_memory();

}  // namespace clevis::elasticity
