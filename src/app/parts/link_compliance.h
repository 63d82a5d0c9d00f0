#pragma once

#include "app/scenes/load_scene.h"

namespace clevis::app {

/// Links that pressure on further faces strains, which shares nothing here.
enum class PressedLinks { kElastic, kRigid };

/// The mechanism, every body with a part of that part's compliance by finite
/// elements.
/// @throws Error L002, L003, L004, M003, F….
mechanism::MechanismDefinition with_link_compliances(const LoadedScene& loaded,
                                                     PressedLinks pressed);

/// Makes that the scene's mechanism, if it asks for elastic links.
/// @throws Error L002, L003, L004, M003, F….
void add_link_compliances(LoadedScene& loaded);

}  // namespace clevis::app
