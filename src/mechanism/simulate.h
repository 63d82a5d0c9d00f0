#pragma once

#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"

namespace clevis::mechanism {

/// Motion of a mechanism.
///
/// Where its drives fix it: positions with branch continuity, velocities,
/// accelerations, and all reactions by equilibrium. No time integration:
/// instants follow from the drives alone, nothing drifts. Otherwise
/// integrate_motion().
/// @throws Error K001–K008.
Motion simulate(const MechanismDefinition& definition,
                const SimulationSettings& settings);

}  // namespace clevis::mechanism
