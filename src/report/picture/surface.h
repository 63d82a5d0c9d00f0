#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace clevis::report {

/// A surface as pictures draw it. An edge of one triangle of a cell alone is
/// one of the mesh.
struct Surface {
  Eigen::MatrixX3d points;  ///< [mm]
  std::vector<std::array<int, 3>> triangles;
  /// How many triangles of each cell, one after another.
  std::vector<int> cell_triangles;
  Eigen::VectorXd stress;  ///< von Mises, at the points [MPa]
  /// Red, green, blue in the place of the stress, with every edge.
  std::optional<std::array<std::uint8_t, 3>> colour = {};
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
