#pragma once

#include <vector>

#include "mechanism/element_base/acting_element.h"
#include "mechanism/forces/force_model.h"

namespace clevis::mechanism {

// Motion of force elements' lines by that of bodies. Bodies by slot, in [m/s],
// [rad/s] and per second; `now`: the element's response to that state.

/// Part of the line's acceleration that velocities cause [m/s²], [rad/s²].
double line_bias(const ActingElement& e, const ElementResponse& now,
                 const std::vector<Twist>& twists);
/// [m/s²], [rad/s²].
double line_acceleration(const ActingElement& e, const ElementResponse& now,
                         const std::vector<SpatialAcceleration>& accelerations,
                         const std::vector<Twist>& twists);
/// Of a contact's sliding, without what velocities cause [m/s²].
double sliding_acceleration(
    const ActingElement& e, const ElementResponse& now,
    const std::vector<SpatialAcceleration>& accelerations);
/// Rate of the joint's angle along which an element acts [rad/s].
/// @param placed  by joint.
double joint_rate(const ActingElement& e,
                  const std::vector<PlacedJoint>& placed,
                  const std::vector<Twist>& twists);
/// Whether the line of any element counts its turns.
bool counts_turns(const ForceModel& forces);

}  // namespace clevis::mechanism
