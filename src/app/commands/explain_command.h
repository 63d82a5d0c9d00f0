#pragma once

#include <string>

#include "base/exit_code.h"

namespace clevis::app {

/// Prints what a code of refusal means and what to do; all codes if empty.
/// @throws Error U001 for a code that there is not.
ExitCode explain_command(const std::string& code);

}  // namespace clevis::app
