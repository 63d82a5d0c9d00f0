#pragma once

#include "app/request/options.h"
#include "base/exit_code.h"

namespace clevis::app {

/// Twists and stresses of the scene's transmissions.
/// @throws Error as read_scene.
ExitCode transmission_command(const Options& options);

}  // namespace clevis::app
