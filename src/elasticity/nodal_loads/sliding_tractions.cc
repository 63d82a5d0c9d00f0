#include "elasticity/nodal_loads/sliding_tractions.h"

#include <algorithm>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "base/messages/errors.h"
#include "loads/pressure/wall_pressure.h"

namespace clevis::elasticity {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

part::Bore touched(const part::Bore& cylinder, const loads::Seat& seat,
                   const loads::ContactZone& zone) {
  const double half = 0.5 * cylinder.length;
  const double low = std::max(-half, zone.low[0]);
  const double high = std::min(half, zone.high[0]);
  part::Bore result = cylinder;
  result.axis_L = seat.slide->along_L;
  result.p_LC += 0.5 * (low + high) * result.axis_L;
  result.length = high - low;
  return result;
}

SlidingTractions::SlidingTractions(const loads::LoadHistory& history,
                                   std::size_t seat,
                                   const std::optional<part::Bore>& cylinder,
                                   const std::string& part_name)
    : history_(history),
      seat_index_(seat),
      seat_(history.seats[seat]),
      cylinder_(cylinder),
      part_name_(part_name) {
  if (seat_.kind == loads::SeatKind::kBearing && !cylinder) {
    throw Error("L002", "part " + part_name + ", group " + seat_.group,
                "a guide bears on this group, but it is no circular cylinder",
                "Name the group bore_* or round_* if it is round.");
  }
  // Of all seats: a slide that only guides carries round-off.
  double reach = 0.0;
  for (const auto& other : history.seats) {
    reach = std::max(reach, (other.p_LS - seat_.p_LS).norm());
  }
  for (const auto& instant : history.instants) {
    for (const loads::Wrench& wrench : instant.wrenches) {
      largest_force_ = std::max(largest_force_, wrench.force.norm());
      largest_moment_ = std::max(largest_moment_, wrench.moment.norm());
    }
  }
  largest_moment_ += reach * largest_force_;
}

loads::ContactZone SlidingTractions::zone(std::size_t instant) const {
  const auto& zones = history_.instants[instant].zones;
  return zones.empty() ? loads::ContactZone{} : zones[seat_index_];
}

loads::BearingTraction SlidingTractions::bearing(std::size_t instant) const {
  const loads::Wrench& wrench =
      history_.instants[instant].wrenches[seat_index_];
  const part::Bore bore = touched(*cylinder_, seat_, zone(instant));
  return {
      bore,
      {.force = wrench.force,
       .moment = wrench.moment + (seat_.p_LS - bore.p_LC).cross(wrench.force)}};
}

Matrix3Xd SlidingTractions::at(std::size_t instant,
                               const loads::GroupQuadrature& quadrature,
                               const Matrix3Xd& outward) const {
  constexpr double kNegligible = 1e-7;  // of the largest over the motion
  const auto& load = history_.instants[instant];
  const loads::Wrench& wrench = load.wrenches[seat_index_];
  const Index n = quadrature.weights.size();
  const std::string place = "part " + part_name_ + ", joint " + seat_.name;
  if (n == 0) {
    throw Error("L007", place,
                load.label + ": the counterpart touches nothing of \"" +
                    seat_.group + "\"",
                "Correct the joint's points, `offset` or `width`.");
  }
  Matrix3Xd tractions = Matrix3Xd::Zero(3, n);
  if (seat_.kind == loads::SeatKind::kBearing) {
    tractions = bearing(instant).tractions(quadrature.points, outward);
  } else if (seat_.kind != loads::SeatKind::kMean &&
             (wrench.force.norm() > kNegligible * largest_force_ ||
              wrench.moment.norm() > kNegligible * largest_moment_)) {
    const auto pressure =
        loads::wall_pressure(quadrature, outward, wrench, seat_.p_LS);
    if (!pressure) {
      throw Error("L007", place,
                  fmt::format("{}: the counterpart pulls at \"{}\", or tilts "
                              "off it; a wall only takes pressure",
                              load.label, seat_.group),
                  "Name the wall that faces it, too: groups = [\"" +
                      seat_.group + "\", \"OTHER\"]");
    }
    tractions = *pressure;
  }
  loads::DiscreteBalance(quadrature, seat_.p_LS).correct(wrench, tractions);
  return tractions;
}

}  // namespace clevis::elasticity
