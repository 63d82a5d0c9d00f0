#pragma once

#include <Eigen/Core>

#include "mesh/cells/part_mesh.h"

namespace clevis::stress {

/// Depth over radius up to which degree 4 shows it to 0.3 % (a disc's bore
/// under pressure, regression.deep_cells) [1].
inline constexpr double kResolvedDepth = 2.0;

/// How deep the cells under a hollow curved face reach beside a point, over the
/// face's radius there, at most; 0: no such face is within a cell of it [1].
/// Stress about a hole falls within a radius or so: of cells that are many
/// times as deep no degree shows it.
/// @param at  in L [m].
double depth_over_radius(const mesh::PartMesh<3>& mesh,
                         const Eigen::Vector3d& at);

}  // namespace clevis::stress
