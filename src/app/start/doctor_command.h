#pragma once

#include "base/exit_code.h"

namespace clevis::app {

/// Prints what is installed and what it is needed for.
/// @return kIo if `check` could not run.
ExitCode doctor_command();

}  // namespace clevis::app
