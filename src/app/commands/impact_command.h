#pragma once

#include "app/request/options.h"
#include "base/exit_code.h"

namespace clevis::app {

/// Ejector and blow of the scene by beam theory, without finite elements.
/// @throws Error as read_scene.
ExitCode impact_command(const Options& options);

}  // namespace clevis::app
