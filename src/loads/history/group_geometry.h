#pragma once

#include <string>

#include <Eigen/Core>

#include "part/bore.h"

namespace clevis::loads {

/// Where the groups of a part lie, as `mesh` found them.
struct GroupGeometry {
  std::string name;
  bool is_cylinder{};
  part::Bore cylinder;                                 ///< if is_cylinder
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< of the face area [m]
  double area{};                                       ///< [m²]
  /// ∫ n dA [m²] and ∫ p_LQ × n dA [m³], n the outward unit normal.
  Eigen::Vector3d area_vector = Eigen::Vector3d::Zero();
  Eigen::Vector3d area_moment = Eigen::Vector3d::Zero();
  /// ∫ n nᵀ dA [m²]: of rank one where the group is flat, or walls that face
  /// each other.
  Eigen::Matrix3d normal_square = Eigen::Matrix3d::Zero();
  /// ∫ (|r|² 1 − r rᵀ) dA about the centroid [m⁴]; zero: not known.
  Eigen::Matrix3d second_moment = Eigen::Matrix3d::Zero();
  Eigen::Matrix3Xd points = {};  ///< of its faces, which they span [m]
};

}  // namespace clevis::loads
