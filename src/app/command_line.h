#pragma once

#include "base/messages/errors.h"

namespace clevis::app {

/// Parses the arguments, runs the command that they name and returns its exit
/// code. --help and --version print to stdout and pass.
/// @throws Error U001 for a wrong command line, else what the command throws.
ExitCode run_command_line(int argc, const char* const* argv);

}  // namespace clevis::app
