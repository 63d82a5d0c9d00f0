#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "assessment/job/part_job.h"
#include "assessment/stretches/excited_modes.h"
#include "elasticity/vibration/seat_shapes.h"
#include "loads/history/load_history.h"
#include "loads/holds/spread_seats.h"

namespace clevis::assessment {

/// How far a part swings whose hold changes.
struct TravellingVibration {
  double stress{}, deflection{};  ///< largest over the largest at rest [1]
  double error{};                 ///< of both [1]
  double still{};                 ///< largest stress of the shapes at rest [Pa]
  double beyond_rest{};           ///< largest of what is not at rest [Pa]
  Eigen::Vector3d at;             ///< of the largest stress, in L [m]
  std::string group;
  double time{};     ///< likewise [s]
  int shapes{};      ///< that move it, those of the rigid part among them
  double highest{};  ///< of them [Hz]
  double lowest{};   ///< that its loads excite, as it is held then [Hz]
};

/// Follows the shapes of a part through all of a motion, held and weighed at
/// each time where its slides are then: from rest at its first instant, excited
/// by what its seats carry.
/// @param motion   followed_loads(). @param shapes  of the spread seats, with
///   fields. @param hold_of  at an instant, not spread.
/// @param as_if_held  instants of holds to compare with; none where seats
///   travel.
/// @return nothing where other loads than those of seats act, springs swing
///   other bodies, holds come and go, instants are too far apart, or more steps
///   are wanted than is worth while; and where it swings as far, to a tenth, as
///   one of `as_if_held` lets it.
std::optional<TravellingVibration> follow_holds(
    const PartJob& job, const LoadSet& motion, const loads::SpreadSeats& seats,
    const elasticity::SeatShapes& shapes,
    const std::function<loads::SeatHold(std::size_t)>& hold_of,
    const CountedPeriods& periods, const std::vector<std::size_t>& as_if_held);

}  // namespace clevis::assessment
