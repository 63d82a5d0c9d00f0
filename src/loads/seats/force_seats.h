#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "loads/history/load_history.h"
#include "loads/seats/seat_context.h"
#include "mechanism/definition/motion.h"

namespace clevis::loads {

/// Where a [[force]] of the scene acts on the part.
struct ForceSeat {
  Seat seat;
  std::size_t index{};    ///< of MechanismDefinition::elements
  double area{};          ///< of the face [m²]
  std::size_t chamber{};  ///< of a gas cylinder
  double environment{};   ///< of it [Pa]
  std::vector<GroupGeometry> pressurized;
};

/// Name of a force's seat.
std::string force_seat_name(const std::string& force);
bool is_force_seat(const Seat& seat);

/// Refuses a body on which a force acts that has no seat. @throws Error L004.
void require_force_seats(const SeatContext& context);

/// Seats of the forces, in the order of the part's definition.
/// @throws Error L002, L003, L004, M003.
std::vector<ForceSeat> force_seats(const SeatContext& context);

/// Force [N] and moment about the seat's p_LS [N m] on the part at an instant.
Wrench force_on(const SeatContext& context, const mechanism::Instant& instant,
                const ForceSeat& seat);

/// Pressure on its walls: that of the gas above the environment's, or of an
/// effort that pushes over the face's area [Pa].
double pressure_of(const mechanism::Instant& instant, const ForceSeat& seat);

}  // namespace clevis::loads
