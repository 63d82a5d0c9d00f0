#pragma once

#include <cstddef>
#include <vector>

#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"

namespace clevis::mechanism {

/// Joints whose reactions lack what the teeth of a coupling press the wheels
/// apart and across with, as each of its joints takes a torque or a force
/// along its coordinate alone: those two, and where their wheels do not run on
/// one body, or equilibrium leaves their reactions open, all on the ways from
/// one to the other. In rising order.
std::vector<std::size_t> joints_without_teeth(
    const MechanismDefinition& definition, const Motion& motion,
    std::size_t coupling);

}  // namespace clevis::mechanism
