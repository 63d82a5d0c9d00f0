#pragma once

#include <string>
#include <vector>

#include "loads/seats/seat_context.h"
#include "mechanism/definition/motion.h"

namespace clevis::loads {

/// Groups that a pressure acts on without leaving a force.
/// @throws Error L002, M003.
std::vector<GroupGeometry> pressurized_groups(
    const SeatContext& context, const std::vector<std::string>& names,
    const std::string& place);

/// Whether the body carries wheels of a coupling: their bearings alone load it
/// then. @pre the coupling has teeth.
bool carries_wheels(const SeatContext& context,
                    const mechanism::CouplingDefinition& coupling);

/// Refuses a body on which a joint or drive acts that has no seat.
/// @throws Error L004.
void require_seats(const SeatContext& context);

/// Refuses a body on which a coupling's tooth force acts by joints in whose
/// reactions it is not.
/// @throws Error L004.
void require_tooth_forces(const SeatContext& context,
                          const mechanism::Motion& motion);

/// Seats of the joints, in the order of the part's definition.
/// @throws Error L002, L003, L004, M003.
std::vector<JointSeat> joint_seats(const SeatContext& context);

/// Seats of the drives, in the order of the part's definition; of several
/// drives of one joint one each, on the same face.
/// @throws Error L002, L004, M003.
std::vector<DrivenSeat> driven_seats(const SeatContext& context);

}  // namespace clevis::loads
