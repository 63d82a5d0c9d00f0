#pragma once

#include <optional>

#include <Eigen/Core>

#include "elasticity/fe_space/group_trace.h"

namespace clevis::stress {

/// A plane face as the section of a bar.
struct PlaneSection {
  Eigen::Vector3d centroid, normal;  ///< [m]; outward
  double area{};                     ///< [m²]
  Eigen::Matrix3d flexibility;  ///< inverse, in the plane, of ∫ r rᵀ dA [1/m⁴]
  double polar{};               ///< ∫ r² dA [m⁴]
};

/// None if the faces of the group are not in one plane.
std::optional<PlaneSection> plane_section(const elasticity::GroupTrace& trace);

/// Largest von Mises of two states per instant: at the points N/A + M y/I about
/// both axes with the torsion M_n r/I_p, and the means N/A, V/A [Pa].
/// @param force, moment  on the part, about the centroid, 3 × instants [N],
///   [N m].
/// @param points  of the face, 3 × points [m].
Eigen::VectorXd nominal_stress(const PlaneSection& section,
                               const Eigen::Matrix3Xd& force,
                               const Eigen::Matrix3Xd& moment,
                               const Eigen::Matrix3Xd& points);

}  // namespace clevis::stress
