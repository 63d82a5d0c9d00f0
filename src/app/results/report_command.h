#pragma once

#include "app/request/options.h"
#include "base/exit_code.h"

namespace clevis::app {

/// Writes a result as one HTML file and prints its name.
/// @throws Error I003, I008 if the folder holds no whole result.
ExitCode report_command(const ReportOptions& options);

}  // namespace clevis::app
