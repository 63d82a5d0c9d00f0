#pragma once

#include "app/request/command_options.h"
#include "app/request/options.h"
#include "base/messages/exit_code.h"

namespace clevis::app {

/// Twists and stresses of the scene's transmissions.
/// @throws Error as read_scene.
ExitCode transmission_command(const Options& options);

/// Declares the options of `clevis transmission`. @return what runs it.
Run declare_transmission(CLI::App& command);

}  // namespace clevis::app
