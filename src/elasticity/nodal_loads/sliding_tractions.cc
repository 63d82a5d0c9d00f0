#include "elasticity/nodal_loads/sliding_tractions.h"

#include <algorithm>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "base/messages/errors.h"
#include "loads/history/balance.h"
#include "loads/pressure/pin_pressure.h"
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
      part_name_(part_name),
      scale_(history, seat) {
  if (seat_.kind == loads::SeatKind::kBearing && !cylinder) {
    throw Error("L002", "part " + part_name + ", group " + seat_.group,
                "a guide bears on this group, but it is no circular cylinder",
                "Name the group bore_* or round_* if it is round.");
  }
}

loads::ContactZone SlidingTractions::zone(std::size_t instant) const {
  const auto& zones = history_.instants[instant].zones;
  return zones.empty() ? loads::ContactZone{} : zones[seat_index_];
}

loads::BearingTraction SlidingTractions::bearing(std::size_t instant) const {
  const loads::Wrench& wrench =
      history_.instants[instant].wrenches[seat_index_];
  const part::Bore bore = touched(*cylinder_, seat_, zone(instant));
  return {bore,
          loads::about(wrench.force, wrench.moment, seat_.p_LS, bore.p_LC)};
}

Matrix3Xd SlidingTractions::at(std::size_t instant,
                               const loads::GroupQuadrature& quadrature,
                               const Matrix3Xd& outward) const {
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
    const part::Bore bore = touched(*cylinder_, seat_, zone(instant));
    const loads::PinPressure guide(bore, quadrature, outward);
    if (const auto pressed = guide.tractions(
            loads::about(wrench.force, wrench.moment, seat_.p_LS, bore.p_LC))) {
      tractions = *pressed;
    } else if (!scale_.is_negligible(wrench)) {
      loads::refuse_open_wall("part " + part_name_ + ", " + seat_.name,
                              seat_.group, load.label);
    }
  } else if (seat_.kind != loads::SeatKind::kMean &&
             !scale_.is_negligible(wrench)) {
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
