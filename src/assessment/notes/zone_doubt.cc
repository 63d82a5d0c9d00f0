#include "assessment/notes/zone_doubt.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "assessment/judge/doubt.h"

namespace clevis::assessment {
namespace {

using Eigen::Vector3d;

/// √3/π: von Mises that a strip under even pressure reaches inside, over the
/// pressure, in plane strain; of shorter zones it is more.
constexpr double kLeastOfPressure = 0.55;
/// Cells up to twice as long as the zone show it. Longer ones miss so much of
/// the peak for each length of the zone: an estimate, on the safe side of what
/// finer cells were seen to change.
constexpr double kResolved = 2.0;
constexpr double kPerLength = 0.1;

/// What presses on a wall at an instant.
struct Pressed {
  const loads::Seat* seat = nullptr;
  double length{};    ///< of the zone, along the slide [m]
  double pressure{};  ///< mean over it [Pa]
  double cell{};      ///< length of the longest cell there [m]
};

double extent(const Eigen::Matrix3Xd& points, const Vector3d& along) {
  const Eigen::RowVectorXd places = along.transpose() * points;
  return places.maxCoeff() - places.minCoeff();
}

/// Longest cell along the slide that the zone touches [m].
double cell_at(const mesh::PartMesh<3>& mesh, const loads::Seat& seat,
               const loads::ContactZone& zone) {
  const Vector3d& along = seat.slide->along_L;
  double longest = 0.0;
  for (const mesh::BoundaryFace& face : mesh.boundary) {
    if (face.group < 0 ||
        mesh.groups[static_cast<std::size_t>(face.group)].name != seat.group) {
      continue;
    }
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const unsigned v : mesh.cells[static_cast<std::size_t>(face.cell)]) {
      const double place = along.dot(mesh.vertices[v] - seat.p_LS);
      low = std::min(low, place);
      high = std::max(high, place);
    }
    if (high > zone.low[0] && low < zone.high[0]) {
      longest = std::max(longest, high - low);
    }
  }
  return longest;
}

/// Nothing: the seat presses on all of its group, or not at all.
Pressed pressed_by(const PartJob& job, const loads::LoadHistory& history,
                   const loads::InstantLoad& instant, std::size_t s) {
  const loads::Seat& seat = history.seats[s];
  if (!seat.slide || instant.zones.size() <= s) return {};
  const loads::ContactZone& zone = instant.zones[s];
  const double length = zone.high[0] - zone.low[0];
  const auto group =
      std::ranges::find(job.groups, seat.group, &loads::GroupGeometry::name);
  if (!std::isfinite(length) || group == job.groups.end()) return {};
  const loads::SlideWall& wall = *seat.slide;
  double width = zone.high[1] - zone.low[1];
  if (group->is_cylinder) {
    width = 2.0 * group->cylinder.radius;
  } else if (!std::isfinite(width)) {
    width = extent(group->points, wall.across_L);
  }
  const Vector3d& force = instant.wrenches[s].force;
  const double across = group->is_cylinder ? force.cross(wall.along_L).norm()
                                           : std::abs(force.dot(wall.normal_L));
  return {&seat, length, across / (length * width), 0.0};
}

/// That by which the peak is off most [Pa].
double amount_of(const Pressed& pressed, double peak) {
  const double by_cell =
      kPerLength * std::max(0.0, pressed.cell / pressed.length - kResolved) *
      peak;
  const bool is_lost = peak < kLeastOfPressure * pressed.pressure;
  return is_lost ? std::max(by_cell, pressed.pressure - peak) : by_cell;
}

/// Whether a point lies so near to a zone that this decides about its stress.
bool is_near(const Vector3d& at, const loads::Seat& seat,
             const loads::ContactZone& zone) {
  const double place = seat.slide->along_L.dot(at - seat.p_LS);
  const double length = zone.high[0] - zone.low[0];
  return place > zone.low[0] - length && place < zone.high[0] + length;
}

}  // namespace

void add_zone_doubt(const PartJob& job, PartResult& result) {
  if (!(result.peak.value > 0.0)) return;
  PeakStress& judged = result.peak_outside ? *result.peak_outside : result.peak;
  Pressed worst;
  double most = 0.0;
  for (const LoadSet& set : job.load_sets) {
    for (const loads::InstantLoad& instant : set.history.instants) {
      for (std::size_t s = 0; s < set.history.seats.size(); ++s) {
        Pressed pressed = pressed_by(job, set.history, instant, s);
        if (pressed.seat == nullptr) continue;
        if (instant.label == judged.label &&
            is_near(judged.at, *pressed.seat, instant.zones[s])) {
          pressed.cell = cell_at(job.mesh, *pressed.seat, instant.zones[s]);
        }
        const double amount = amount_of(pressed, judged.value);
        if (amount > most) {
          most = amount;
          worst = pressed;
        }
      }
    }
  }
  if (most == 0.0) return;
  widen_for_cells(judged, most, job.tolerance);
  result.notes.push_back(fmt::format(
      "{} presses on {:.3g} mm of its wall with {:.3g} MPa, which cells there "
      "are too long to show: mesh finer there",
      worst.seat->name, worst.length * 1e3, worst.pressure * 1e-6));
}

}  // namespace clevis::assessment
