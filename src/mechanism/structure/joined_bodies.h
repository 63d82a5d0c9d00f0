#pragma once

#include <vector>

#include "mechanism/definition/definition.h"

namespace clevis::mechanism {

/// Groups of bodies that joints hold together, each of two and more.
struct JoinedBodies {
  /// By any joint, without the ground.
  std::vector<std::vector<BodyIndex>> moving;
  /// By welds, and by joints whose motions drives prescribe: they hand all
  /// moments on.
  std::vector<std::vector<BodyIndex>> stiffly;
};
JoinedBodies joined_bodies(const MechanismDefinition& mechanism);

}  // namespace clevis::mechanism
