#pragma once

#include <string>

#include "mesh/cells/part_mesh.h"

namespace clevis::mesh {

/// Vertices of a boundary face in cyclic order; three or four.
std::vector<unsigned> face_cycle(const PartMesh<3>& mesh,
                                 const BoundaryFace& face);

/// Area vector [m²] through the corners of a face; its sign is that of the
/// cycle.
Eigen::Vector3d area_vector(const PartMesh<3>& mesh,
                            const std::vector<unsigned>& cycle);

/// The cylinder of a round that is one facet wide, so that its corners alone
/// do not determine it: the arc through the facet's two axial edges that is
/// tangent to the surfaces beside them, a flat face or a fitted cylinder.
///
/// @param place  group, for messages.
/// @throws Error M009 if the group does not lie between two surfaces to which
///   one and the same arc is tangent (1e-5 of its radius).
part::Bore fit_tangent_cylinder(const PartMesh<3>& mesh, int group,
                                const std::string& place);

}  // namespace clevis::mesh
