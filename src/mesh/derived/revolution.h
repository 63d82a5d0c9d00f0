#pragma once

#include <optional>

#include <Eigen/Core>

#include "mesh/cells/part_mesh.h"

namespace clevis::mesh {

/// A solid of revolution: half a section through its axis, and where it lies.
struct Revolution {
  /// Coordinates (along the axis, radius) [m]; its groups those of the part
  /// that have a face all round. Thickness 1 and mid_plane_z 0 have no meaning.
  PartMesh<2> meridian;
  Eigen::Vector3d origin;  ///< on the axis, where the first coordinate is 0 [m]
  /// Along the axis, and the directions of the angles 0 and 90° about it; in L.
  Eigen::Matrix3d axes;

  /// Position in L [m] of (along the axis, radius) [m] at an angle [rad].
  Eigen::Vector3d at(const Eigen::Vector2d& meridian_point, double angle) const;
};

/// The solid of revolution that a mesh of hexahedra stacked in closed rings
/// describes (to 1e-8 of its size at the faces between the cells of a ring):
/// about the axis of a named cylinder, or a line along x, y or z through Lo or
/// the middle of the box around the part. Nothing if it is none: cells at an
/// axis stand in no ring, so that the part must be hollow.
std::optional<Revolution> find_revolution(const PartMesh<3>& mesh);

}  // namespace clevis::mesh
