#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "loads/history/group_geometry.h"
#include "loads/history/load_history.h"

namespace clevis::loads {

/// What there is of a cylinder's wall.
struct PartialWall {
  Eigen::Matrix3Xd points;  ///< of a quadrature, in L [m]
  Eigen::Matrix3Xd areas;   ///< there: outward normals times weights [m²]
  /// Along the axis from its middle, where there is some, rising [m].
  std::vector<std::pair<double, double>> spans;
};

/// Notes pins and guides whose walls are not whole, with the share that is
/// there; of pins the largest pressure beside that of a wall closed all round.
/// @param wall_of  of a group that is not whole.
/// @throws Error L002 where that is more than twice as much, or the wall would
///   have to pull.
void note_partial_walls(
    const std::vector<GroupGeometry>& groups,
    const std::function<PartialWall(const GroupGeometry&)>& wall_of,
    const std::string& place, LoadHistory& history);

}  // namespace clevis::loads
