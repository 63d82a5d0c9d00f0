#pragma once

#include "mechanism/definition/motion.h"
#include "mechanism/driven_motion/driven_instants.h"
#include "mechanism/driven_motion/driven_model.h"

namespace clevis::mechanism {

/// Assembles a driven mechanism at the start of its motion.
/// @return the first regular moment; what precedes it goes to `motion`, the
///   first instant too.
/// @throws Error K001, K003, K007 where [[initial]] contradicts the drives,
/// K010,
///   K005 if the start is a change point and must not be, or has no way on.
DrivenMoment start_driven(const DrivenModel& model, DrivenInstants& instants,
                          const SimulationSettings& settings, Motion& motion);

}  // namespace clevis::mechanism
