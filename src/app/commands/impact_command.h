#pragma once

#include "app/request/command_options.h"
#include "app/request/options.h"
#include "base/messages/exit_code.h"

namespace clevis::app {

/// Ejector and blow of the scene by beam theory, without finite elements.
/// @throws Error as read_scene.
ExitCode impact_command(const Options& options);

/// Declares the options of `clevis impact`. @return what runs it.
Run declare_impact(CLI::App& command);

}  // namespace clevis::app
