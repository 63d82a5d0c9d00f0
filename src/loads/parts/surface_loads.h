#pragma once

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "loads/history/group_geometry.h"
#include "loads/history/load_history.h"

namespace clevis::loads {

/// Pressures [Pa] and tractions [Pa] on groups; both on one group become one
/// load. In the order of the groups' names.
/// @throws Error M003 for a group that the mesh lacks.
std::vector<SurfaceLoad> surface_loads(
    const std::map<std::string, double>& pressures,
    const std::map<std::string, Eigen::Vector3d>& tractions,
    const std::vector<GroupGeometry>& groups, const std::string& place);

}  // namespace clevis::loads
