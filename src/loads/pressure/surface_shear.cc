#include "loads/pressure/surface_shear.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "loads/history/balance.h"
#include "loads/pressure/face_pressure.h"

namespace clevis::loads {
namespace {

using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

/// Shear of one load.
struct Shear {
  Vector3d even = Vector3d::Zero();
  double turning{};
  Vector3d spin = Vector3d::Zero();
};

/// A pin's wall takes force along and moment about its axis evenly.
Shear of_bearing(const GroupGeometry& group, const Wrench& wrench) {
  const part::Bore& bore = group.cylinder;
  const double wall =
      is_full_cylinder(group) ? part::wall_area(bore) : group.area;
  const Vector3d& axis = bore.axis_L;
  return {wrench.force.dot(axis) / wall * axis,
          std::abs(wrench.moment.dot(axis)) / (bore.radius * wall)};
}

/// @param force  on a group as an even traction [N].
/// @param moment  about its centroid [N m].
Shear of_face(const GroupGeometry& group, const Vector3d& force,
              const Vector3d& moment) {
  const Vector3d n = mean_normal(group.area_vector, group.area);
  const Vector3d turns = n.isZero(0.0) ? moment : Vector3d(n.dot(moment) * n);
  const double known = n.dot(group.second_moment * n);
  // Of a circle; a square has 5 % more.
  const double second_moment =
      known > 0.0 ? known : group.area * group.area / (2.0 * kPi);
  return {(force - n.dot(force) * n) / group.area,
          2.0 * turns.norm() / (group.area * std::sqrt(group.area / kPi)),
          turns / second_moment};
}

}  // namespace

Eigen::Matrix3Xd GroupShear::at(const Vector3d& point) const {
  const Vector3d arm = point - centre;
  Eigen::Matrix3Xd all = even;
  for (Eigen::Index i = 0; i < spin.cols(); ++i) {
    all.col(i) += spin.col(i).cross(arm);
  }
  return all;
}

SurfaceShear surface_shear(const LoadHistory& history,
                           const std::vector<GroupGeometry>& groups) {
  const auto instants = static_cast<Eigen::Index>(history.instants.size());
  SurfaceShear found;
  double pressure = 0.0;  // largest of a group, even
  const auto put = [&](Eigen::Index instant, const GroupGeometry& group,
                       const Shear& shear) {
    GroupShear& at = found[group.name];
    if (at.turning.size() == 0) {
      at.even.setZero(3, instants);
      at.turning.setZero(instants);
      at.spin.setZero(3, instants);
      at.centre = group.centroid;
    }
    at.even.col(instant) += shear.even;
    at.turning[instant] += shear.turning;
    at.spin.col(instant) += shear.spin;
  };
  const auto known = [&groups](const std::string& name) {
    const auto group = std::ranges::find(groups, name, &GroupGeometry::name);
    return group == groups.end() ? nullptr : &*group;
  };
  for (Eigen::Index i = 0; i < instants; ++i) {
    const InstantLoad& instant = history.instants[static_cast<std::size_t>(i)];
    for (std::size_t s = 0; s < history.seats.size(); ++s) {
      const Seat& seat = history.seats[s];
      const GroupGeometry* group = known(seat.group);
      if (seat.slide || group == nullptr) continue;
      const Wrench& wrench = instant.wrenches[s];
      pressure = std::max(pressure, wrench.force.norm() / group->area);
      put(i, *group,
          seat.kind == SeatKind::kBearing && group->is_cylinder
              ? of_bearing(*group, wrench)
              : of_face(*group, wrench.force, wrench.moment));
    }
    for (const SurfaceLoad& load : instant.surface_loads) {
      const GroupGeometry* group = known(load.group);
      if (group == nullptr) continue;
      pressure = std::max(pressure, load.total / group->area);
      put(i, *group,
          of_face(*group, group->area * load.traction, Vector3d::Zero()));
    }
  }
  constexpr double kCounts = 1e-3;  // less raises no stress by a percent
  std::erase_if(found, [&](const auto& entry) {
    const GroupShear& shear = entry.second;
    return (shear.even.colwise().norm().transpose() + shear.turning)
               .maxCoeff() < kCounts * pressure;
  });
  return found;
}

}  // namespace clevis::loads
