#include "loads/parts/surface_loads.h"

#include <cmath>

#include <Eigen/Geometry>

#include "loads/history/balance.h"

namespace clevis::loads {

using Eigen::Vector3d;

std::vector<SurfaceLoad> surface_loads(
    const std::map<std::string, double>& pressures,
    const std::map<std::string, Vector3d>& tractions,
    const std::vector<GroupGeometry>& groups, const std::string& place) {
  std::map<std::string, SurfaceLoad> by_group;
  for (const auto& [group, pressure] : pressures) {
    by_group[group].pressure = pressure;
  }
  for (const auto& [group, traction] : tractions) {
    by_group[group].traction = traction;
  }
  std::vector<SurfaceLoad> loads;
  for (auto& [name, load] : by_group) {
    const GroupGeometry& group = find_group(groups, name, place);
    load.group = name;
    const Vector3d traction_force = group.area * load.traction;
    load.resultant = {
        .force = -load.pressure * group.area_vector + traction_force,
        .moment = -load.pressure * group.area_moment +
                  group.centroid.cross(traction_force)};
    load.total = group.area * (std::abs(load.pressure) + load.traction.norm());
    loads.push_back(load);
  }
  return loads;
}

}  // namespace clevis::loads
