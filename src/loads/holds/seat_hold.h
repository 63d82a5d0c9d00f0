#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "loads/history/load_history.h"
#include "mechanism/definition/motion.h"
#include "mechanism/neighbours/neighbours.h"

namespace clevis::loads {

/// What the rest of the mechanism holds and weighs at a part's seats at an
/// instant of its motion.
/// @param seats  of the part's history: joints by their names, drives by
/// theirs.
SeatHold seat_hold(const mechanism::Neighbours& neighbours,
                   const mechanism::Instant& instant,
                   const std::vector<Seat>& seats);

/// Where springs swing other bodies by themselves: what is held and sprung as
/// the part gives way slowly, those bodies at rest between their springs and
/// joints.
SeatHold held_slowly(SeatHold hold);

/// The same with other wrenches, of as many rows each, where it has any.
/// @param changed  6 n × columns -> 6 m × columns, linear [1].
SeatHold with_wrenches(
    SeatHold hold,
    const std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)>& changed);

/// The same of a history that has got more seats behind its own, which hold and
/// weigh nothing.
SeatHold on_more_seats(SeatHold hold, std::size_t seats);

/// Whether the mechanism holds and weighs the same.
/// @param apart  of sums of squares [1].
bool are_alike(const SeatHold& a, const SeatHold& b, double apart);

/// Whether bodies spin at the seats, beyond round-off of those that turn in a
/// plane.
bool has_spin(const SeatHold& hold);

/// Index of the instant at which the seats' forces are largest. @pre any.
std::size_t hardest_instant(const std::vector<InstantLoad>& instants);

}  // namespace clevis::loads
