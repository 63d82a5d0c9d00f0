#pragma once

#include "app/request/options.h"
#include "base/exit_code.h"

namespace clevis::app {

/// Compares a result with its baseline, quantity by quantity.
/// @throws Error as read_result.
ExitCode compare_command(const CompareOptions& options);

}  // namespace clevis::app
