#pragma once

#include <string>

#include "mesh/cells/part_mesh.h"

namespace clevis::mesh {

/// Sets the cylinder of each group bore_* and round_*: from its corner nodes;
/// if they are one facet wide, from the curved nodes of the file, or else
/// from the surfaces beside it (fit_tangent_cylinder).
///
/// @throws Error M009 (place: `file`, group) if a corner is off the cylinder
///   by more than 1e-5 of the radius, a facet spans 90° or lies across the
///   axis, or no cylinder is determined.
void fit_cylinder_groups(PartMesh<3>& mesh, const std::string& file);

}  // namespace clevis::mesh
