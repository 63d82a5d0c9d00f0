#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

namespace clevis::report {

/// A surface as pictures draw it. An edge of one triangle of a cell alone is
/// one of the mesh.
struct Surface {
  Eigen::MatrixX3d points;  ///< [mm]
  std::vector<std::array<int, 3>> triangles;
  std::vector<int>
      cell_triangles;      ///< how many of each cell, one after another
  Eigen::VectorXd stress;  ///< von Mises, at the points [MPa]
};

/// From where something is seen, in parallel projection: rows to the right, up
/// and towards the eye; a rotation.
using Sight = Eigen::Matrix3d;

/// Seen from the direction `towards` with `right` about to the right; lengths
/// of any unit [mm].
/// @pre They are neither zero nor parallel.
Sight sight(const Eigen::Vector3d& towards, const Eigen::Vector3d& right);

/// From where a part is seen best: a flat one straight, others askew so that
/// `marked` [mm] is not hidden, if that can be. The longest side lies across.
Sight best_sight(const Surface& surface, const Eigen::Vector3d& marked);

/// Whether nothing of the surface stands between the place [mm] and the eye.
bool is_seen(const Surface& surface, const Sight& sight,
             const Eigen::Vector3d& place);

}  // namespace clevis::report
