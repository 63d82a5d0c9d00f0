#pragma once

#include <string>

#include "app/request/command_options.h"
#include "base/messages/exit_code.h"

namespace clevis::app {

/// Prints what a code of refusal means and what to do; all codes if empty.
/// @throws Error U001 for a code that there is not.
ExitCode explain_command(const std::string& code);

/// Declares the options of `clevis explain`. @return what runs it.
Run declare_explain(CLI::App& command);

}  // namespace clevis::app
