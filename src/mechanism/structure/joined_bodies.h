#pragma once

#include <vector>

#include "mechanism/definition/definition.h"

namespace clevis::mechanism {

/// Groups of bodies that hang together, each of two and more.
struct JoinedBodies {
  /// By any joint, without the ground.
  std::vector<std::vector<BodyIndex>> moving;
  /// By welds, slides and joints whose turns drives prescribe: they hand
  /// bending on, whoever holds the way of a slide, but for gas.
  std::vector<std::vector<BodyIndex>> stiffly;
  /// By these, and where force elements that hold an angle take what joints
  /// and drives leave: bending is handed on, too. So by a bushing alone.
  std::vector<std::vector<BodyIndex>> elastically;
};
JoinedBodies joined_bodies(const MechanismDefinition& mechanism);

}  // namespace clevis::mechanism
