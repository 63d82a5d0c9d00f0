#pragma once

#include "app/request/command_options.h"
#include "app/request/options.h"
#include "base/messages/exit_code.h"

namespace clevis::app {

/// Solves each part by every model and degree, and by CalculiX.
/// @throws Error as run_in_plugin() and the command itself.
ExitCode study_command(const Options& options);

/// Declares the options of `clevis study`. @return what runs it.
Run declare_study(CLI::App& command);

}  // namespace clevis::app
