#pragma once

#include <string>
#include <vector>

#include "loads/seats/force_seats.h"
#include "loads/seats/seat_context.h"
#include "mechanism/definition/motion.h"

namespace clevis::loads {

/// A line for each force whose line of action passes the middle of its face
/// farther away than the face is large: the face takes it as if an arm that is
/// not in the mesh carried it there. Of a bore also where the line meets the
/// axis more than 2 % of the length from its middle. Along its line a force may
/// be moved.
std::vector<std::string> off_face_notes(const SeatContext& context,
                                        const std::vector<ForceSeat>& seats,
                                        const mechanism::Motion& motion);

}  // namespace clevis::loads
