#pragma once

#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"

namespace clevis::report {

/// Energies of all bodies at an instant [J].
struct MechanismEnergy {
  double kinetic{};
  double potential{};  ///< of gravity, 0 with all centres of mass at Wo
};

/// Koenig's theorem: ½ m v_C² + ½ ω·I ω, and −m g·p_WC, over the bodies.
MechanismEnergy mechanism_energy(
    const mechanism::MechanismDefinition& definition,
    const mechanism::Instant& instant);

}  // namespace clevis::report
