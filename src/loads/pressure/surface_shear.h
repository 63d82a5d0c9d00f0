#pragma once

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "loads/history/group_geometry.h"
#include "loads/history/load_history.h"

namespace clevis::loads {

/// Shear on a group at every instant.
struct GroupShear {
  /// The even part: of a force along a face, or along a pin's axis, in L [Pa].
  Eigen::Matrix3Xd even;
  /// The rest, round a pin or a face's normal: there at the rim of a circle of
  /// its area [Pa].
  Eigen::VectorXd turning;
  /// That of a face: spin × (point − centre), L [Pa/m]; zero of a pin, whose
  /// goes along its edges.
  Eigen::Matrix3Xd spin = {};
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< [m]

  /// Of all instants, at a point [Pa].
  Eigen::Matrix3Xd at(const Eigen::Vector3d& point) const;
};
/// By group.
using SurfaceShear = std::map<std::string, GroupShear>;

/// What seats and surface loads do not press with, where that is more than a
/// thousandth of the largest mean pressure on a group. Slides press only.
SurfaceShear surface_shear(const LoadHistory& history,
                           const std::vector<GroupGeometry>& groups);

}  // namespace clevis::loads
