#pragma once

#include <string>
#include <vector>

#include "mesh/cells/part_mesh.h"
#include "mesh/rounds/faceted_rounds.h"

namespace clevis::mesh {

/// Degree of the mapping that holds a cylinder to 1e-8 of its radius when its
/// facets span 22.5° or less (degree 4: 2.3e-8).
inline constexpr int kCylinderDegree = 5;
/// The same for tetrahedra, whose displacements have degree 4 at most: 2.3e-8
/// of the radius.
inline constexpr int kSimplexCylinderDegree = 4;

/// Elevates the geometry to kCylinderDegree (kSimplexCylinderDegree) at least
/// and moves the nodes of the groups that have a cylinder (fit_cylinder_groups)
/// onto it: corners radially, edges with equal angles, faces radially; every
/// other edge, face and interior follows by transfinite blending, so that
/// neighbours still share their points.
void put_on_cylinders(PartMesh<3>& mesh);

/// The same, and faces without a group of their own onto these.
void put_on_cylinders(PartMesh<3>& mesh,
                      const std::vector<FacetedRound>& rounds);

}  // namespace clevis::mesh
