#pragma once

#include "loads/history/group_geometry.h"
#include "loads/history/load_history.h"
#include "loads/seats/seat_spans.h"
#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"
#include "part/mass_properties.h"
#include "part/part_definition.h"

namespace clevis::loads {

/// The motion without the instants at change points: what stands there are
/// reactions of joints that give way, in balance in the deflected position
/// only.
mechanism::Motion loading_motion(mechanism::Motion motion);

/// Loads on a part over the motion of its body: reactions, drive efforts,
/// forces of the scene, inertia and gravity, in frame L.
///
/// Joints, drives and forces become seats. While a sliding drive pushes, its
/// effort over the area of its face is also the pressure of the surface loads
/// on the `pressurized` groups; a gas cylinder puts its gas's there.
/// @throws Error L001 if an instant is out of balance by more than 1e-9 of its
///   load, L002 if a group cannot take what its joint transmits, L003 if a
///   seat's cylinder and its joint do not coincide (1e-6 of the part's size),
///   L004 if a joint, drive or force of the body has no seat, M003 if a group
///   is missing.
LoadHistory part_loads(const mechanism::MechanismDefinition& definition,
                       const mechanism::Motion& motion,
                       mechanism::BodyIndex body,
                       const part::PartDefinition& part,
                       const std::vector<GroupGeometry>& groups,
                       const part::MassProperties& mass);

/// The same with what is known of the seats of all parts: where a slide's
/// counterpart touches. The other one knows this part's alone.
/// @throws Error also L007 if it is not known where a slide touches.
LoadHistory part_loads(const mechanism::MechanismDefinition& definition,
                       const mechanism::Motion& motion,
                       mechanism::BodyIndex body,
                       const part::PartDefinition& part,
                       const std::vector<GroupGeometry>& groups,
                       const part::MassProperties& mass,
                       const SeatSpans& spans);

}  // namespace clevis::loads
