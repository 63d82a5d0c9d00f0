#pragma once

#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"

namespace clevis::mechanism {

/// Fills power_balance_error of all instants: power of the drives and of the
/// loads (weight, forces) less the rate of kinetic energy, from positions,
/// velocities, accelerations and efforts alone.
void judge_power_balance(const MechanismDefinition& definition, Motion& motion);

}  // namespace clevis::mechanism
