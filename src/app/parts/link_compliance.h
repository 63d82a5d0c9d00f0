#pragma once

#include "app/scenes/load_scene.h"

namespace clevis::app {

/// Gives every body with a part the compliance of that part by finite elements,
/// if the scene asks for elastic links.
/// @throws Error L002, L003, L004, M003, F….
void add_link_compliances(LoadedScene& loaded);

}  // namespace clevis::app
