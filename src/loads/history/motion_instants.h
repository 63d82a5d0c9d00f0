#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "loads/history/load_history.h"

namespace clevis::loads {

/// Instants closer than this part of the motion are the two sides of an event:
/// loads may jump there, and nothing lies between [1].
inline constexpr double kEventSides = 1e-8;

/// Number of the instants of the motion; cases stand behind them. Of cases
/// alone the first counts.
std::size_t motion_length(const LoadHistory& history);

/// Duration of the motion [s].
double motion_duration(const LoadHistory& history);

/// The middle of a seat's contact zone along its wall, about the seat's p_LS,
/// at each instant of the motion [m]. Of a zone that ends with the wall by the
/// length of the shortest that does not; NaN where the zone has no end.
std::vector<double> places_on_wall(const LoadHistory& history,
                                   std::size_t seat);

/// The least and the largest of places that are known [m]; of none inf, -inf.
std::pair<double, double> ends_of(const std::vector<double>& places);

/// The longest way of a contact zone from one instant of the motion to the
/// next, over all of its way [1]; 0: none travels.
double longest_slide_step(const LoadHistory& history);

}  // namespace clevis::loads
