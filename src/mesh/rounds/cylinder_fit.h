#pragma once

#include <string>

#include <Eigen/Core>

#include "part/bore.h"

namespace clevis::mesh {

/// The circular cylinder nearest to points of a surface.
struct CylinderFit {
  part::Bore bore;
  double worst{};  ///< largest |distance from the axis − radius| [m]
};

/// Least squares over axis, centre and radius (Gauss–Newton), the axis first
/// taken from the normals. An axis that is a coordinate axis within the
/// accuracy of the points becomes exactly that.
///
/// @param points   of the surface, in L [m].
/// @param normals  of facets between the points; lengths are their weights.
/// @param place    group, for messages.
/// @throws Error M009 if normals or points do not determine a cylinder.
CylinderFit fit_cylinder(const Eigen::Matrix3Xd& points,
                         const Eigen::Matrix3Xd& normals,
                         const std::string& place);

/// Whether facets with these normals can determine an axis: they are not all
/// parallel. The normals' lengths are their weights.
bool determine_axis(const Eigen::Matrix3Xd& normals);

/// Sets middle and length of the part of the axis beside the points [m].
void set_extent(const Eigen::Matrix3Xd& points, part::Bore& bore);

/// Largest |distance from the axis − radius| of the points [m].
double worst_distance(const Eigen::Matrix3Xd& points, const part::Bore& bore);

/// Nearest point on the cylinder, in L [m].
Eigen::Vector3d project(const part::Bore& cylinder, const Eigen::Vector3d& p);

/// Point of the screw line from p to q (both on the cylinder) at t of [0, 1]:
/// angle and height are linear in t.
Eigen::Vector3d screw_line(const part::Bore& cylinder, const Eigen::Vector3d& p,
                           const Eigen::Vector3d& q, double t);

/// Angle from p to q about the axis, in (−π, π] [rad].
double angle_between(const part::Bore& cylinder, const Eigen::Vector3d& p,
                     const Eigen::Vector3d& q);

}  // namespace clevis::mesh
