#pragma once

#include "elasticity/problem/dof_limit.h"
#include "mesh/cells/part_mesh.h"

namespace clevis::elasticity {

/// The highest degree of the displacement, `wanted` at most and 1 at least,
/// that the limit admits on a mesh.
template <int dim>
int admitted_degree(const mesh::PartMesh<dim>& mesh, int wanted,
                    DofLimit limit);

}  // namespace clevis::elasticity
