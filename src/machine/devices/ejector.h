#pragma once

#include <string>

#include "part/material.h"

namespace clevis::machine {

/// A lever on a pivot C, pulled by a magnet at A and held back by a return
/// spring at D; its pusher at B strikes the end of a round rod clamped at the
/// other (electromechanical puller of a rotor line).
struct EjectorDefinition {
  std::string name;
  double arm_magnet{}, arm_pusher{}, arm_spring{};  ///< CA, CB, CD [m]
  double inertia{};       ///< J_C of all that moves, about C [kg m²]
  double magnet_force{};  ///< F0, at the start of the travel [N]
  double magnet_range{};  ///< l: where the force would be zero [m]
  double travel{};        ///< S_A of the armature until the pusher strikes [m]
  double spring_stiffness{};  ///< c [N/m]
  double spring_preset{};     ///< S_D0: squeezed at the start [m]
  part::Material workpiece;
  double diameter{}, length{};  ///< of the rod; its free length h [m]
  double safety_factor = 1.0;   ///< n on its yield strength
  std::string place;            ///< file:line:column
};

}  // namespace clevis::machine
