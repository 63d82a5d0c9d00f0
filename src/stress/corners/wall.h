#pragma once

#include "mesh/cells/part_mesh.h"
#include "stress/corners/boundary_corner.h"

namespace clevis::stress {

/// Way through the material from a corner along its bisector to the surface
/// on the other side, the boundary faces taken as flat [m]; the part's size
/// if nothing is met.
template <int dim>
double wall_thickness_at(const mesh::PartMesh<dim>& mesh,
                         const BoundaryCorner& corner);

}  // namespace clevis::stress
