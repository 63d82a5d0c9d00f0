#pragma once

#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"

namespace clevis::mechanism {

/// Motion of a mechanism with coordinates that no drive prescribes, from rest
/// or the initial velocities, by integration in time.
///
/// @throws Error K001 (does not assemble), K003 (drives contradict), K007
///   (initial velocities contradict), K008 (no step short enough), K013 (takes
///   too long).
Motion integrate_motion(const MechanismDefinition& definition,
                        const SimulationSettings& settings);

}  // namespace clevis::mechanism
