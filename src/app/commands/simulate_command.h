#pragma once

#include "app/request/command_options.h"
#include "app/request/options.h"
#include "base/messages/exit_code.h"

namespace clevis::app {

/// Moves the mechanism: reactions, powers and peaks over time, as a table or
/// JSON on stdout and as files with --out.
/// @throws Error as load_scene and simulate.
ExitCode simulate_command(const Options& options);

/// Declares the options of `clevis simulate`. @return what runs it.
Run declare_simulate(CLI::App& command);

}  // namespace clevis::app
