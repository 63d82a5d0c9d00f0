#pragma once

#include "app/request/options.h"
#include "base/exit_code.h"

namespace clevis::app {

/// Moves the mechanism: reactions, powers and peaks over time, as a table or
/// JSON on stdout and as files with --out.
/// @throws Error as load_scene and simulate.
ExitCode simulate_command(const Options& options);

}  // namespace clevis::app
