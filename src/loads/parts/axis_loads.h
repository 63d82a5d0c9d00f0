#pragma once

#include <string>
#include <vector>

#include "loads/history/load_history.h"
#include "loads/seats/seat_context.h"
#include "part/mass_properties.h"

namespace clevis::loads {

/// Lets the forces of joints that stand a little off the axes of their
/// cylinders act on these axes, as pins can: moments of the offsets are taken
/// away, and what is then out of balance is balanced by the part's pins with
/// the least forces that do it. (A rod between two pins is then loaded along
/// the line between its bores.) Where that takes more than kLargestRelief of
/// the load, as of pins on one axis, inertia takes it up. Does nothing where
/// all joints lie on their axes.
/// @param seats    of joints, the first of the history.
/// @param history  in balance, before and after; notes are added.
void act_on_axes(const SeatContext& context,
                 const std::vector<JointSeat>& seats,
                 const part::MassProperties& mass, LoadHistory& history);

}  // namespace clevis::loads
