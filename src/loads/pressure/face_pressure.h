#pragma once

#include <Eigen/Core>

#include "loads/pressure/discrete_balance.h"

namespace clevis::loads {

/// Direction along which a face presses, unit; zero of one that closes round,
/// as a wall does.
/// @param area_vector  ∫ n dA [m²]. @param area  [m²].
Eigen::Vector3d mean_normal(const Eigen::Vector3d& area_vector, double area);

/// Even pressure whose resultant along the face's mean normal is that of a
/// force: curved faces feel no shear of it. Zero on flat faces, where an even
/// traction is the same, and on those that close round.
/// @param outward  unit normals at the points. @param force  [N].
/// @return tractions [Pa], one column per point.
Eigen::Matrix3Xd face_pressure(const GroupQuadrature& quadrature,
                               const Eigen::Matrix3Xd& outward,
                               const Eigen::Vector3d& force);

}  // namespace clevis::loads
