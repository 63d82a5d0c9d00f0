#pragma once

#include "mechanism/driven_motion/driven_motion.h"

namespace clevis::mechanism {

/// A motion that the drives fix, at its uniform instants and, if the settings
/// want that, where loads are largest or jump.
/// @param motion  of the definition and settings.
/// @throws Error as DrivenMotion.
Motion run_driven(const MechanismDefinition& definition,
                  const SimulationSettings& settings,
                  const DrivenMotion& motion);

}  // namespace clevis::mechanism
