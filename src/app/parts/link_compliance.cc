#include "app/parts/link_compliance.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "elasticity/solid/seat_compliance.h"
#include "loads/history/balance.h"
#include "loads/seats/force_seats.h"
#include "loads/seats/part_seats.h"

namespace clevis::app {
namespace {

/// The sharing of elastic links knows a coupling by its torques on the joints,
/// which strain what carries its wheels otherwise than its teeth do.
/// @throws Error L004.
void require_no_teeth(const loads::SeatContext& context) {
  for (const auto& coupling : context.definition.couplings) {
    // One without is refused with its seats.
    if (!coupling.teeth || !loads::carries_wheels(context, coupling)) continue;
    throw Error("L004", context.place("seats"),
                fmt::format("the part carries the wheels of coupling \"{}\", "
                            "whose teeth strain it: links = \"elastic\" leaves "
                            "that out",
                            coupling.name),
                "Take links = \"rigid\" and give the joints compliances that "
                "stand for the links too.");
  }
}

mechanism::LinkCompliance link_compliance(const LoadedScene& loaded,
                                          const LoadedPart& part,
                                          mechanism::BodyIndex body) {
  const loads::SeatContext context{loaded.scene.mechanism, body,
                                   part.definition, part.groups,
                                   loads::part_size(part.groups, part.mass)};
  loads::require_seats(context);
  require_no_teeth(context);
  mechanism::LinkCompliance link;
  std::vector<loads::Seat> seats;
  for (const loads::JointSeat& seat : loads::joint_seats(context)) {
    link.joints.push_back(static_cast<int>(seat.joint.index));
    link.points.push_back(seat.seat.p_LS);
    seats.push_back(seat.seat);
  }
  std::vector<loads::Seat> loaded_seats;
  for (const loads::ForceSeat& force : loads::force_seats(context)) {
    if (!force.pressurized.empty()) continue;  // no wrench on one face
    link.loads.push_back({static_cast<int>(force.index), force.seat.p_LS});
    loaded_seats.push_back(force.seat);
  }
  auto [by_wrench, by_spin, by_load] = elasticity::seat_compliance(
      part.mesh, part.definition.material, part.mass, std::move(seats),
      std::move(loaded_seats), part.definition.name);
  link.matrix = std::move(by_wrench);
  link.by_spin = std::move(by_spin);
  link.by_load = std::move(by_load);
  return link;
}

bool is_pressed(const LoadedPart& part) {
  return !std::ranges::all_of(part.definition.force_seats,
                              &std::vector<std::string>::empty,
                              &part::ForceSeat::pressurized);
}

}  // namespace

mechanism::MechanismDefinition with_link_compliances(const LoadedScene& loaded,
                                                     PressedLinks pressed) {
  mechanism::MechanismDefinition mechanism = loaded.scene.mechanism;
  for (const LoadedPart& part : loaded.parts) {
    const auto body = loaded.body_of(part.definition.name);
    if (body == mechanism::kGround) continue;
    if (pressed == PressedLinks::kRigid && is_pressed(part)) continue;
    mechanism.bodies[static_cast<std::size_t>(body)].compliance =
        link_compliance(loaded, part, body);
  }
  return mechanism;
}

void add_link_compliances(LoadedScene& loaded) {
  if (loaded.scene.simulation.links == mechanism::LinkStiffness::kElastic) {
    loaded.scene.mechanism =
        with_link_compliances(loaded, PressedLinks::kElastic);
  }
}

}  // namespace clevis::app
