#pragma once

#include <cstddef>
#include <vector>

#include "loads/history/load_history.h"
#include "loads/seats/force_seats.h"
#include "loads/seats/seat_context.h"
#include "mechanism/definition/motion.h"

namespace clevis::loads {

/// Forces on a part whose lines go through points of other bodies as the part
/// gives way: of links between two pins that nothing else loads, of rods of
/// given length, of springs and rams between two points. A force F that presses
/// over a length l gains F u/l across as its seat moves across by u. A hinge
/// lets a link turn about its own axis only.
/// @param first_force  index of the first of `by_force` among all seats.
/// @return of seats that such forces act on, moments about none.
/// Source: docs/theory/09_elasticity.md, "Buckling".
std::vector<FollowingForce> following_forces(
    const SeatContext& context, const mechanism::Instant& instant,
    const std::vector<JointSeat>& by_joint,
    const std::vector<ForceSeat>& by_force, std::size_t first_force);

}  // namespace clevis::loads
