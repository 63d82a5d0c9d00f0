#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "part/load_series.h"

namespace clevis::scene {

/// A row of a load history in the file's frame, and how the part stands in it.
struct RowLoads {
  part::SeriesInstant loads;  ///< vectors in the file's frame
  /// From the part's frame to the file's.
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  std::string place;  ///< file:line:column
};

/// Refuses rows between which the part turns so far, by its orientation or its
/// angular velocity, that it is not known how. @throws Error S006.
void require_known_turns(const std::vector<RowLoads>& rows);

/// The rows in L, and instants between those from which loads in L go no
/// straight line to the next: the part turns while the vectors change evenly in
/// the file's frame; where loads are said to be linear its spin changes, whose
/// square is no line. Between the others they are one to 1e-4 of the loads.
/// @param rows  times never fall.
std::vector<part::SeriesInstant> instants_in_part(
    const std::vector<RowLoads>& rows, part::BetweenRows between);

}  // namespace clevis::scene
