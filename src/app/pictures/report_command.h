#pragma once

#include "app/request/options.h"
#include "base/exit_code.h"

namespace clevis::app {

/// Writes the page of a result and prints where it stands.
/// @throws Error as read_result_folder, I002.
ExitCode report_command(const ReportOptions& options);

}  // namespace clevis::app
