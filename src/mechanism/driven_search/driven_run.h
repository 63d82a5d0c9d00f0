#pragma once

#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"

namespace clevis::mechanism {

/// A motion that the drives fix, at its uniform instants and, if the settings
/// want that, where loads are largest or jump.
/// @throws Error as DrivenMotion.
Motion run_driven(const MechanismDefinition& definition,
                  const SimulationSettings& settings);

}  // namespace clevis::mechanism
