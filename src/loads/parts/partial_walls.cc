#include "loads/parts/partial_walls.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "loads/history/balance.h"
#include "loads/pressure/load_scale.h"
#include "loads/pressure/pin_pressure.h"

namespace clevis::loads {
namespace {

constexpr double kMega = 1e6;

/// The same wall closed all round.
WallMoments closed(const PartialWall& wall) {
  WallMoments moments;
  for (const auto& [low, high] : wall.spans) {
    moments.length += high - low;
    moments.first += (high * high - low * low) / 2.0;
    moments.second += (std::pow(high, 3) - std::pow(low, 3)) / 3.0;
  }
  return moments;
}

/// Largest pressures of a seat over its history [Pa].
struct Largest {
  double there{}, closed{};
  std::string label;  ///< of the instant of the former
};

Largest largest_of(const LoadHistory& history, std::size_t seat,
                   const part::Bore& bore, const PartialWall& wall,
                   const std::string& place) {
  const GroupQuadrature quadrature{wall.points,
                                   wall.areas.colwise().norm().transpose()};
  const PinPressure pin(bore, quadrature, wall.areas.colwise().normalized());
  const WallMoments whole = closed(wall);
  const LoadScale scale(history, seat);
  Largest found;
  for (const InstantLoad& instant : history.instants) {
    const Wrench& wrench = instant.wrenches[seat];
    if (scale.is_negligible(wrench)) continue;
    const auto pressure = pin.largest_pressure(wrench);
    if (!pressure)
      refuse_open_wall(place, history.seats[seat].group, instant.label);
    found.closed =
        std::max(found.closed, largest_bearing_pressure(bore, wrench, whole));
    if (*pressure <= found.there) continue;
    found.there = *pressure;
    found.label = instant.label;
  }
  return found;
}

}  // namespace

void note_partial_walls(
    const std::vector<GroupGeometry>& groups,
    const std::function<PartialWall(const GroupGeometry&)>& wall_of,
    const std::string& place, LoadHistory& history) {
  constexpr double kTooMuch = 2.0;  // of the pressure on a whole wall
  for (std::size_t s = 0; s < history.seats.size(); ++s) {
    const Seat& seat = history.seats[s];
    if (seat.kind != SeatKind::kBearing) continue;
    const GroupGeometry& group = find_group(groups, seat.group, place);
    if (is_full_cylinder(group)) continue;
    const PartialWall wall = wall_of(group);
    const double share =
        group.area /
        (2.0 * std::numbers::pi * group.cylinder.radius * closed(wall).length);
    const std::string what =
        fmt::format("{} presses on \"{}\", of whose wall {:.3g} % is there",
                    seat.name, seat.group, 100.0 * share);
    if (seat.slide) {
      history.notes.push_back(what + ": the rest of it carries the load");
      continue;
    }
    const Largest largest =
        largest_of(history, s, group.cylinder, wall, place + ", " + seat.name);
    if (!(largest.there > 0.0)) continue;
    const std::string pressures = fmt::format(
        "pressure reaches {:.4g} MPa ({}), all round it would reach "
        "{:.4g} MPa",
        largest.there / kMega, largest.label, largest.closed / kMega);
    if (largest.there > kTooMuch * largest.closed) {
      throw Error("L002", place,
                  fmt::format("{}: too little of it is where the load points "
                              "to; {}",
                              what, pressures),
                  "Let the load point to the wall, or name the faces that "
                  "carry it and load them by `traction`.");
    }
    history.notes.push_back(what + ": " + pressures);
  }
}

}  // namespace clevis::loads
