#pragma once

#include "elasticity/vibration/seat_shapes.h"
#include "loads/history/load_history.h"

namespace clevis::assessment {

/// Whether springs of the mechanism move the part's first frequencies, or these
/// those of rigid bodies on the springs, or dampers nearly hold it: else
/// both vibrate by themselves. By less than a tenth of the damping ratio they
/// do not; a damper that only takes energy is left out on the safe side.
/// @param damping   of the part. @param duration  of the motion [s].
bool springs_count(const elasticity::SeatShapes& shapes,
                   const loads::SeatHold& hold, double damping,
                   double duration);

}  // namespace clevis::assessment
