#pragma once

#include <map>
#include <string>
#include <vector>

#include "loads/history/group_geometry.h"
#include "loads/history/load_history.h"

namespace clevis::loads {

/// Largest shear that seats and surface loads put on each group over all
/// instants [Pa]; where it ends the stress has no bound. Of moments about a
/// face's normal that at the rim of a circle of its area. Slides press only.
std::map<std::string, double> surface_shear(
    const LoadHistory& history, const std::vector<GroupGeometry>& groups);

}  // namespace clevis::loads
