#pragma once

#include "app/request/command_options.h"
#include "app/request/options.h"
#include "base/messages/exit_code.h"

namespace clevis::app {

/// Compares a result with its baseline, quantity by quantity.
/// @throws Error as read_result.
ExitCode compare_command(const CompareOptions& options);

/// Declares the options of `clevis compare`. @return what runs it.
Run declare_compare(CLI::App& command);

}  // namespace clevis::app
