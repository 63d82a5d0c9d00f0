#pragma once

#include <optional>
#include <string>

#include "mesh/cells/part_mesh.h"

namespace clevis::elasticity {

/// Degrees of freedom that a solution of a part may have at most; absent: as
/// many as the memory holds.
using DofLimit = std::optional<int>;

/// @param dofs  of the solution, mirrored halves counted in.
/// @throws Error F007 if they are more than the limit, before anything is
///   assembled.
void require_dofs(double dofs, DofLimit limit, const std::string& place);

/// The highest degree of the displacement, `wanted` at most and 1 at least,
/// that the limit admits on a mesh.
template <int dim>
int admitted_degree(const mesh::PartMesh<dim>& mesh, int wanted,
                    DofLimit limit);

}  // namespace clevis::elasticity
