#pragma once

#include <string>

namespace clevis::elasticity {

/// Bytes that a nested-dissection Cholesky factor of a mesh with so many
/// degrees of freedom takes: 11 N^(4/3) entries in 3-D (calibrated on compact
/// bodies; slender ones need less), 8 N log₂ N in the plane.
double factor_bytes(int dim, double dofs);

/// @param available  memory of the machine [bytes].
/// @throws Error F004 if the factor would not fit, before anything is
///   allocated.
void require_memory(int dim, double dofs, double available,
                    const std::string& place);

/// Physical memory of this machine [bytes].
double physical_memory();

}  // namespace clevis::elasticity
