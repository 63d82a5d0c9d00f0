#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "beam/sections/part_model.h"
#include "beam/sections/station.h"
#include "loads/history/load_history.h"
#include "loads/parts/part_loads.h"
#include "part/mass_properties.h"

namespace clevis::beam {

/// A piece of a part between two neighbouring seats, without the seats'
/// own cylinders.
struct Span {
  std::size_t from{}, to{};       ///< seats, ascending along the line
  std::vector<double> positions;  ///< of the stations from `from` [m]
  std::vector<Station> stations;
  std::vector<LoadsBeyond> beyond;  ///< per station
  double length{};                  ///< between the seats [m]
  /// Whether the first and the last station stand beside the seats' own
  /// cylinders.
  bool starts_at_seat = false, ends_at_seat = false;
};

/// A straight row of seats, taken as a beam.
struct PinLine {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
  std::vector<std::size_t> seats;  ///< ascending along the direction
  std::vector<Span> spans;
};

/// The beams of a part: one through all seats if they stand in a row (to 5 %
/// of its length), else one for each pair of bearing seats.
///
/// A span has 25 stations from rim to rim; left out are those whose plane
/// passes through the cylinder of a third seat (its load is on neither side)
/// or misses the material.
std::vector<PinLine> pin_lines(const PartModel& model,
                               const part::MassProperties& mass,
                               const std::vector<loads::GroupGeometry>& groups,
                               const loads::LoadHistory& history);

}  // namespace clevis::beam
