#pragma once

#include <string>
#include <vector>

#include "loads/history/load_history.h"
#include "loads/seats/seat_context.h"
#include "loads/seats/seat_spans.h"
#include "mechanism/definition/motion.h"

namespace clevis::loads {

/// The wall of a seat that slides: a cylinder, or faces along the slide, flat
/// each (one, two that face each other, the four of a square bore).
/// @throws Error L002 if the group is neither, L003 if it is not along the
///   slide, M003.
SlideWall slide_wall(const SeatContext& context, const part::Seat& wanted,
                     const BodyJoint& joint);

/// Whether a zone has no edge on the wall.
bool is_whole(const ContactZone& zone);

/// Sets the zone of each seat that slides at every instant, and notes.
///
/// The zone is where the counterpart lies, as far as the part's own group
/// reaches: the `length` that the user gives, about the joint's point on the
/// counterpart, or else the counterpart's own seat. A cylinder that is touched
/// all over at every instant is a bearing like others: it loses its `slide`.
/// @throws Error L007 if it is not known what touches the wall, or if it has
///   left it.
void set_contact_zones(const SeatContext& context,
                       const mechanism::Motion& motion, const SeatSpans& spans,
                       const std::vector<JointSeat>& seats,
                       LoadHistory& history);

}  // namespace clevis::loads
