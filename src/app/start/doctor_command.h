#pragma once

#include "app/request/command_options.h"
#include "base/messages/exit_code.h"

namespace clevis::app {

/// Prints what is installed and what it is needed for.
/// @return kIo if `check` could not run.
ExitCode doctor_command();

/// Declares the options of `clevis doctor`. @return what runs it.
Run declare_doctor(CLI::App& command);

}  // namespace clevis::app
