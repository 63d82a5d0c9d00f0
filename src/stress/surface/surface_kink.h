#pragma once

#include <vector>

#include <Eigen/Core>

#include "mesh/cells/part_mesh.h"

namespace clevis::stress {

/// Error of the mesh on a curved surface that it does not follow exactly:
/// the largest product of the angle between neighbouring faces of the boundary
/// along their common edge, where it is below 20° everywhere, and of the stress
/// that flows across the edge [Pa]. Other edges are edges of the part.
/// @param cells  whose edges are looked at.
/// @param stress  of these cells, rows xx, yy, zz, xy, yz, xz at the points of
///   elasticity::lattice with four subdivisions [Pa], points × 6.
double kinked_stress(const mesh::PartMesh<3>& mesh,
                     const std::vector<int>& cells,
                     const std::vector<Eigen::MatrixXd>& stress);

}  // namespace clevis::stress
