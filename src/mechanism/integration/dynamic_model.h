#pragma once

#include "mechanism/constraints/solving_frame.h"
#include "mechanism/definition/definition.h"
#include "mechanism/equations_of_motion/forward_dynamics.h"
#include "mechanism/reactions/equilibrium.h"

namespace clevis::mechanism {

/// A mechanism whose motion forces decide, and its equations.
struct DynamicModel {
  /// @param given, wanted  outlive this.
  DynamicModel(const MechanismDefinition& given,
               const SimulationSettings& wanted);

  const MechanismDefinition& definition;
  const SimulationSettings& settings;
  SolvingFrame frame;  ///< at the centres of mass
  ForwardDynamics dynamics;
  EquationsOfMotion& equations;  ///< of the dynamics
  Projection& projection;        ///< likewise
  Equilibrium equilibrium;
};

}  // namespace clevis::mechanism
