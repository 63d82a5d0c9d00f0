#pragma once

#include "app/request/options.h"
#include "base/messages/exit_code.h"
#include "scene/scene.h"

namespace clevis::app {

/// Natural frequencies [Hz] and shapes of the parts: table or JSON on stdout,
/// files in the output folder.
/// @throws Error as load_scene.
ExitCode run_modes(const Options& options, scene::Scene scene);

}  // namespace clevis::app
