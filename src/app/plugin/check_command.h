#pragma once

#include "app/request/command_options.h"
#include "app/request/options.h"
#include "base/messages/exit_code.h"

namespace clevis::app {

/// Checks every part over the motion and its cases; progress goes to stderr.
/// @throws Error as run_in_plugin() and the command itself.
ExitCode check_command(const Options& options);

/// Declares the options of `clevis check`. @return what runs it.
Run declare_check(CLI::App& command);

}  // namespace clevis::app
