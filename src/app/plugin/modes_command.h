#pragma once

#include "app/request/command_options.h"
#include "app/request/options.h"
#include "base/messages/exit_code.h"

namespace clevis::app {

/// Computes free vibrations of the parts.
/// @throws Error as run_in_plugin() and the command itself.
ExitCode modes_command(const Options& options);

/// Declares the options of `clevis modes`. @return what runs it.
Run declare_modes(CLI::App& command);

}  // namespace clevis::app
