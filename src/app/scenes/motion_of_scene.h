#pragma once

#include "app/request/options.h"
#include "mechanism/definition/motion.h"
#include "scene/scene.h"

namespace clevis::app {

/// The motion of a scene's mechanism, also where its loads are largest or jump;
/// tells on stderr how far an integration is.
mechanism::Motion motion_of_scene(const scene::Scene& scene,
                                  const Options& options);

}  // namespace clevis::app
