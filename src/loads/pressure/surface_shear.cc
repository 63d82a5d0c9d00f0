#include "loads/pressure/surface_shear.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace clevis::loads {
namespace {

using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

/// Of force and moment that a pin's wall takes as even shear: along its axis
/// and about it.
double of_bearing(const part::Bore& bore, const Wrench& wrench) {
  const double wall = 2.0 * kPi * bore.radius * bore.length;
  return std::hypot(wrench.force.dot(bore.axis_L),
                    wrench.moment.dot(bore.axis_L) / bore.radius) /
         wall;
}

/// Unit normal of a flat group; zero of others.
Vector3d flat_normal(const GroupGeometry& group) {
  constexpr double kFlat = 0.999;  // of the area
  return group.area_vector.norm() < kFlat * group.area
             ? Vector3d(Vector3d::Zero())
             : group.area_vector.normalized();
}

/// What of an even traction does not press on a group.
Vector3d along_face(const GroupGeometry& group, const Vector3d& traction) {
  const Vector3d n = flat_normal(group);
  return traction - n.dot(traction) * n;
}

double of_face(const GroupGeometry& group, const Wrench& wrench) {
  const Vector3d n = flat_normal(group);
  const double turning =
      n.isZero(0.0) ? wrench.moment.norm() : std::abs(wrench.moment.dot(n));
  return along_face(group, wrench.force).norm() / group.area +
         2.0 * turning / (group.area * std::sqrt(group.area / kPi));
}

}  // namespace

std::map<std::string, double> surface_shear(
    const LoadHistory& history, const std::vector<GroupGeometry>& groups) {
  std::map<std::string, double> largest;
  double pressure = 0.0;  // largest of a group, even
  const auto put = [&](const std::string& name, const auto& shear_on) {
    const auto group = std::ranges::find(groups, name, &GroupGeometry::name);
    if (group == groups.end()) return;
    double& most = largest[name];
    most = std::max(most, shear_on(*group));
  };
  for (const InstantLoad& instant : history.instants) {
    for (std::size_t s = 0; s < history.seats.size(); ++s) {
      const Seat& seat = history.seats[s];
      if (seat.slide) continue;
      put(seat.group, [&](const GroupGeometry& group) {
        const Wrench& wrench = instant.wrenches[s];
        pressure = std::max(pressure, wrench.force.norm() / group.area);
        return seat.kind == SeatKind::kBearing && group.is_cylinder
                   ? of_bearing(group.cylinder, wrench)
                   : of_face(group, wrench);
      });
    }
    for (const SurfaceLoad& load : instant.surface_loads) {
      put(load.group, [&](const GroupGeometry& group) {
        pressure = std::max(pressure, load.total / group.area);
        return along_face(group, load.traction).norm();
      });
    }
  }
  constexpr double kCounts = 1e-3;  // less raises no stress by a percent
  std::erase_if(largest, [&](const auto& shear) {
    return shear.second < kCounts * pressure;
  });
  return largest;
}

}  // namespace clevis::loads
