#pragma once

#include <functional>
#include <span>
#include <vector>

#include "mechanism/forces/force_model.h"
#include "mechanism/reactions/equilibrium.h"

namespace clevis::mechanism {

/// The force that friction of a joint follows [N].
/// @param q  of its line [m] or [rad].
double followed_force(const ActingElement& element, double q,
                      const JointReaction& reaction);

/// Reactions and the friction that is proportional to them, at known
/// accelerations, by iteration.
/// @param acting  given the loads and efforts.
/// @param balance  reactions under wrenches about M by slot.
/// @throws Error K011 if the friction does not settle.
Equilibrium::Solution balance_with_friction(
    const MechanismDefinition& definition, const ForceModel& forces,
    ForceState& acting, std::size_t slots,
    const std::function<Equilibrium::Solution(std::span<const Twist>)>&
        balance);

/// @throws Error K011 if friction follows a reaction that equilibrium leaves
///   open and slides, or holds more than that lets it. @param joints  of an
///   instant.
void require_unique_loads(const MechanismDefinition& definition,
                          const ForceModel& forces, const ForceState& acting,
                          const std::vector<JointReaction>& joints);

/// @throws Error K011 if any friction follows such a reaction: for where a
///   motion cannot go on.
void refuse_open_loads(const MechanismDefinition& definition,
                       const ForceModel& forces,
                       const std::vector<JointReaction>& joints);

enum class MovedBy { kDrives, kForces };

/// @throws Error K011 if friction follows the reaction of a joint that teeth
///   load, which does not know their force: as it is not resolved, or as the
///   motion is found without it.
void refuse_friction_beside_teeth(const MechanismDefinition& definition,
                                  MovedBy moved_by);

/// @throws Error K011, always: a joint with such friction jams.
/// @param element  its friction. @param t  [s].
[[noreturn]] void refuse_self_locking(const MechanismDefinition& definition,
                                      std::size_t element, double t);

}  // namespace clevis::mechanism
