#pragma once

#include <vector>

#include "mechanism/definition/definition.h"

namespace clevis::mechanism {

/// Groups of bodies that hang together, each of two and more.
struct JoinedBodies {
  /// By any joint, without the ground.
  std::vector<std::vector<BodyIndex>> moving;
  /// By welds, and by joints whose motions drives prescribe: they hand all
  /// moments on.
  std::vector<std::vector<BodyIndex>> stiffly;
  /// By these, and where force elements that hold a position take what joints
  /// and drives leave: moments are handed on, too. So by a bushing alone.
  std::vector<std::vector<BodyIndex>> elastically;
};
JoinedBodies joined_bodies(const MechanismDefinition& mechanism);

}  // namespace clevis::mechanism
