#include "loads/parts/axis_loads.h"

#include <algorithm>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "loads/history/balance.h"
#include "loads/parts/held_pins.h"
#include "loads/seats/seat_fit.h"

namespace clevis::loads {

using Eigen::Vector3d;

namespace {

/// Pins of a part's joints that do not slide, and their seats.
struct Pins {
  std::vector<std::size_t> seats;
  std::vector<std::string> groups;
};

Pins pins_of(const std::vector<JointSeat>& seats) {
  Pins pins;
  for (std::size_t i = 0; i < seats.size(); ++i) {
    const Seat& seat = seats[i].seat;
    if (seat.kind != SeatKind::kBearing || seat.slide) continue;
    pins.seats.push_back(i);
    pins.groups.push_back(seat.group);
  }
  return pins;
}

double sum_of_forces(const std::vector<Wrench>& wrenches) {
  double sum = 0.0;
  for (const Wrench& wrench : wrenches) sum += wrench.force.norm();
  return sum;
}

}  // namespace

void act_on_axes(const SeatContext& context,
                 const std::vector<JointSeat>& seats,
                 const part::MassProperties& mass, LoadHistory& history) {
  const std::vector<Vector3d> offsets = axis_offsets(context, seats);
  if (std::ranges::all_of(offsets, [](const Vector3d& offset) {
        return offset.isZero(0.0);
      })) {
    return;
  }
  const Pins pins = pins_of(seats);
  const PinReactions reactions =
      pins_in(pins.groups, context.groups, context.size, context.place("pins"));
  double largest_change = 0.0, largest_load = 0.0;
  for (InstantLoad& instant : history.instants) {
    largest_load = std::max(largest_load, sum_of_forces(instant.wrenches));
  }
  for (InstantLoad& instant : history.instants) {
    for (std::size_t i = 0; i < seats.size(); ++i) {
      Wrench& wrench = instant.wrenches[i];
      wrench.moment -= offsets[i].cross(wrench.force);
    }
    const auto change = reactions.balancing(residual(history, instant, mass));
    const double size = sum_of_forces(change);
    if (size > kLargestRelief * largest_load) continue;
    largest_change = std::max(largest_change, size);
    for (std::size_t i = 0; i < pins.seats.size(); ++i) {
      Wrench& wrench = instant.wrenches[pins.seats[i]];
      wrench.force += change[i].force;
      wrench.moment += change[i].moment;
    }
  }
  float_on(mass, history);
  for (const std::string& note : off_axis_notes(context, seats)) {
    history.notes.push_back(note);
  }
  constexpr double kTold = 1e-6;
  if (largest_change <= kTold * largest_load) return;
  history.notes.push_back(fmt::format(
      "to balance the forces that act on the axes, pins' forces are changed by "
      "{:.2g} % of the largest load",
      100.0 * largest_change / largest_load));
}

}  // namespace clevis::loads
