#include "elasticity/solid/plane_loads.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace clevis::elasticity {
namespace {

using Eigen::Vector3d;

/// Largest components of vectors in the plane and out of it.
struct Largest {
  double along = 0.0;
  double across = 0.0;
  void add(const Vector3d& v) {
    along = std::max(along, v.head<2>().norm());
    across = std::max(across, std::abs(v.z()));
  }
  /// For axial vectors: one along z belongs to the plane.
  void add_normal(const Vector3d& v) {
    along = std::max(along, std::abs(v.z()));
    across = std::max(across, v.head<2>().norm());
  }
};

/// Whether a zone ends between the lids of a plate.
bool ends_across(const loads::Seat& seat, const loads::ContactZone& zone) {
  constexpr double kAcross = 1e-9;
  const auto ends = [&](int direction, const Vector3d& along) {
    return std::abs(along.z()) > kAcross &&
           (std::isfinite(zone.low[direction]) ||
            std::isfinite(zone.high[direction]));
  };
  return ends(0, seat.slide->along_L) || ends(1, seat.slide->across_L);
}

bool any_ends_across(const loads::LoadHistory& history) {
  for (std::size_t s = 0; s < history.seats.size(); ++s) {
    if (!history.seats[s].slide) continue;
    for (const auto& instant : history.instants) {
      if (instant.zones.empty()) continue;
      if (ends_across(history.seats[s], instant.zones[s])) return true;
    }
  }
  return false;
}

}  // namespace

bool loads_in_plane(const loads::LoadHistory& history, double mid_plane_z,
                    double size) {
  constexpr double kInPlane = 1e-9;
  if (any_ends_across(history)) return false;
  Largest force, moment, acceleration, rotation;
  for (const auto& instant : history.instants) {
    for (std::size_t s = 0; s < history.seats.size(); ++s) {
      const auto& wrench = instant.wrenches[s];
      const Vector3d lever(0.0, 0.0, history.seats[s].p_LS.z() - mid_plane_z);
      force.add(wrench.force);
      moment.add_normal(wrench.moment + lever.cross(wrench.force));
      size = std::max(size, history.seats[s].p_LS.head<2>().norm());
    }
    for (const auto& load : instant.surface_loads) {
      const Vector3d lever(0.0, 0.0, mid_plane_z);
      // The resultant of a closed pressure is round-off of its total.
      force.along = std::max(force.along, load.total);
      force.add(load.resultant.force);
      force.add(Vector3d(0.0, 0.0, load.traction.z()));
      moment.add_normal(load.resultant.moment -
                        lever.cross(load.resultant.force));
    }
    acceleration.add(instant.rigid.acceleration);
    rotation.add_normal(instant.rigid.alpha);
    rotation.add_normal(instant.rigid.omega);
  }
  return force.across <= kInPlane * force.along &&
         moment.across <= kInPlane * (moment.along + size * force.along) &&
         acceleration.across <= kInPlane * (1.0 + acceleration.along) &&
         rotation.across <= kInPlane * (1.0 + rotation.along);
}

}  // namespace clevis::elasticity
