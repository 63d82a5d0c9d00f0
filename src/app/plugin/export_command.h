#pragma once

#include "app/request/command_options.h"
#include "app/request/options.h"
#include "base/messages/exit_code.h"

namespace clevis::app {

/// Writes the parts as CalculiX decks, or a result as glTF.
/// @throws Error as run_in_plugin() and the command itself.
ExitCode export_command(const Options& options);

/// Declares the options of `clevis export`. @return what runs it.
Run declare_export(CLI::App& command);

}  // namespace clevis::app
