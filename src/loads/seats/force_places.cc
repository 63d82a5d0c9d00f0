#include "loads/seats/force_places.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "loads/seats/seat_fit.h"
#include "part/bore.h"

namespace clevis::loads {

using Eigen::Vector3d;

namespace {

/// A force on the part at an instant, in L.
struct Attack {
  Vector3d force;  ///< [N]
  Vector3d point;  ///< [m]

  /// From the line of action to a point [m].
  Vector3d to(const Vector3d& p) const {
    const Vector3d along = force.normalized();
    return p - point - along.dot(p - point) * along;
  }
  double distance_from(const Vector3d& p) const { return to(p).norm(); }
};

std::vector<Attack> attacks_on(const SeatContext& context,
                               const ForceSeat& seat,
                               const mechanism::Motion& motion) {
  std::vector<Attack> attacks;
  for (const mechanism::Instant& instant : motion.instants) {
    const auto& pose =
        instant.bodies[static_cast<std::size_t>(context.body)].pose;
    const Eigen::Matrix3d R_LW = pose.R_WL.transpose();
    for (const auto& action : instant.elements[seat.index].actions) {
      if (action.body != context.body || action.f_W.isZero(0.0)) continue;
      attacks.push_back({R_LW * action.f_W, R_LW * (action.p_W - pose.p_WL)});
    }
  }
  return attacks;
}

/// The one whose line passes farthest from p, of those that count.
std::optional<Attack> farthest_from(const Vector3d& p,
                                    const std::vector<Attack>& attacks) {
  constexpr double kCounts = 0.1;  // of the largest force
  double largest = 0.0;
  for (const Attack& attack : attacks) {
    largest = std::max(largest, attack.force.norm());
  }
  std::optional<Attack> farthest;
  for (const Attack& attack : attacks) {
    if (attack.force.norm() <= kCounts * largest) continue;
    if (!farthest || attack.distance_from(p) > farthest->distance_from(p)) {
      farthest = attack;
    }
  }
  return farthest;
}

/// Longest side of the box around a group's faces [m].
double size_of(const GroupGeometry& group) {
  if (group.points.cols() == 0) return 0.0;
  return (group.points.rowwise().maxCoeff() - group.points.rowwise().minCoeff())
      .maxCoeff();
}

Vector3d middle_of(const GroupGeometry& group) {
  return group.is_cylinder ? group.cylinder.p_LC : group.centroid;
}

/// The group next to a point, if it is nearer than the group is large.
const GroupGeometry* group_at(const SeatContext& context, const Vector3d& p) {
  const auto distance = [&](const GroupGeometry& group) {
    return (middle_of(group) - p).norm();
  };
  const auto nearest = std::ranges::min_element(context.groups, {}, distance);
  return nearest != context.groups.end() &&
                 distance(*nearest) <= size_of(*nearest)
             ? &*nearest
             : nullptr;
}

/// Of a force that meets a bore's axis away from the middle of its length.
std::optional<std::string> off_middle_note(const std::string& name,
                                           const GroupGeometry& group,
                                           const Attack& attack) {
  if (!group.is_cylinder) return std::nullopt;
  const part::Bore& bore = group.cylinder;
  const double along = std::abs(attack.to(bore.p_LC).dot(bore.axis_L));
  if (!is_off_middle(along, bore)) return std::nullopt;
  return fmt::format(
      "force {} acts {:.4g} mm from the middle of \"{}\" along its axis "
      "({:.3g} % of its length): it bends the part across; if that is not "
      "meant, correct its point",
      name, along * 1e3, group.name, 100.0 * along / bore.length);
}

}  // namespace

std::vector<std::string> off_face_notes(const SeatContext& context,
                                        const std::vector<ForceSeat>& seats,
                                        const mechanism::Motion& motion) {
  std::vector<std::string> notes;
  for (const ForceSeat& seat : seats) {
    const auto group = std::ranges::find(context.groups, seat.seat.group,
                                         &GroupGeometry::name);
    if (group == context.groups.end()) continue;
    const double size = size_of(*group);
    const auto attack =
        farthest_from(seat.seat.p_LS, attacks_on(context, seat, motion));
    if (size == 0.0 || !attack) continue;
    const double distance = attack->distance_from(seat.seat.p_LS);
    const std::string name =
        mechanism::name_of(context.definition.elements[seat.index]);
    if (distance <= size) {
      if (auto note = off_middle_note(name, *group, *attack)) {
        notes.push_back(std::move(*note));
      }
      continue;
    }
    const GroupGeometry* at_point = group_at(context, attack->point);
    notes.push_back(fmt::format(
        "force {} passes \"{}\" {:.4g} mm from its middle, and the face is "
        "{:.4g} mm large: it takes the force as if a rigid arm carried it "
        "there. {}",
        name, group->name, distance * 1e3, size * 1e3,
        at_point != nullptr && at_point != &*group
            ? fmt::format(
                  "At the force's point is \"{0}\": forces = {{ \"{1}\" "
                  "= {{ face = \"{0}\" }} }} if that is meant",
                  at_point->name, name)
            : "Name the face that takes it, or correct its point, if that is "
              "not meant"));
  }
  return notes;
}

}  // namespace clevis::loads
