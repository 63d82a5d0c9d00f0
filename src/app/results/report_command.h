#pragma once

#include "app/request/command_options.h"
#include "app/request/options.h"
#include "base/messages/exit_code.h"

namespace clevis::app {

/// Writes a result as one HTML file and prints its name.
/// @throws Error I003, I008 if the folder holds no whole result.
ExitCode report_command(const ReportOptions& options);

/// Declares the options of `clevis report`. @return what runs it.
Run declare_report(CLI::App& command);

}  // namespace clevis::app
