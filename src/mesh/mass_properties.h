#pragma once

#include <vector>

#include "mesh/part_mesh.h"
#include "part/mass_properties.h"

namespace clevis::mesh {

/// Mass, centre and inertia by quadrature that is exact for the mapped
/// geometry. @param density [kg/m³].
part::MassProperties mass_properties(const PartMesh<3>& mesh, double density);

/// Area [m²], centroid [m] and second moment ∫ (|r|² I − r rᵀ) dA [m⁴] of a
/// group's faces.
struct FaceProperties {
  double area{};
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second_moment = Eigen::Matrix3d::Zero();
};
FaceProperties face_properties(const PartMesh<3>& mesh, int group);

}  // namespace clevis::mesh
