#pragma once

#include <utility>
#include <vector>

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

/// Points of a quadrature of a group's faces [m], and outward normals times
/// weights there [m²], one a column.
struct SurfaceSample {
  Eigen::Matrix3Xd points, areas;
};
SurfaceSample sample_surface(const PartMesh<3>& mesh, int group);

/// Where a group has faces along an axis: stretches from a point on it, rising
/// and apart [m].
std::vector<std::pair<double, double>> spans_along(const PartMesh<3>& mesh,
                                                   int group,
                                                   const Eigen::Vector3d& point,
                                                   const Eigen::Vector3d& axis);

/// Corners of a group's faces, each once a face [m].
Eigen::Matrix3Xd face_corners(const PartMesh<3>& mesh, int group);

}  // namespace clevis::mesh
