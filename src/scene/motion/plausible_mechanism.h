#pragma once

#include "mechanism/definition/definition.h"

namespace clevis::scene {

/// Refuses masses, lengths and inertias that no machine has: units or powers of
/// ten that slipped.
/// @throws Error S011.
void require_plausible(const mechanism::MechanismDefinition& mechanism);

}  // namespace clevis::scene
