#pragma once

#include <Eigen/Core>

#include "mesh/cells/part_mesh.h"
#include "part/mass_properties.h"

namespace clevis::mesh {

/// Mass, centre and inertia by quadrature; the mass is exact for the mapped
/// geometry. @param density [kg/m³].
part::MassProperties mass_properties(const PartMesh<3>& mesh, double density);

/// The same of the plate with its thickness; z from mid_plane_z.
/// @param density [kg/m³].
part::MassProperties mass_properties(const PartMesh<2>& mesh, double density);

/// Area [m²], centroid [m] and second moment ∫ (|r|² I − r rᵀ) dA [m⁴] about
/// the centroid, of a group's faces.
struct FaceProperties {
  double area{};
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second_moment = Eigen::Matrix3d::Zero();
  /// ∫ n dA [m²] and ∫ p × n dA [m³], n the outward unit normal.
  Eigen::Vector3d area_vector = Eigen::Vector3d::Zero();
  Eigen::Vector3d area_moment = Eigen::Vector3d::Zero();
  /// ∫ n nᵀ dA [m²].
  Eigen::Matrix3d normal_square = Eigen::Matrix3d::Zero();
};

/// @param group  index into mesh.groups; -1: all faces without a name.
FaceProperties face_properties(const PartMesh<3>& mesh, int group);

/// Corners of a group's faces, each once a face [m].
Eigen::Matrix3Xd face_corners(const PartMesh<3>& mesh, int group);

}  // namespace clevis::mesh
