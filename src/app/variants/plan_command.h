#pragma once

#include "app/request/options.h"
#include "base/exit_code.h"

namespace clevis::app {

/// Prints one command per variant and writes the plan for `clevis collect`.
/// @throws Error of the first variant that cannot be read, with its place in
///   the table or the scene; I002.
ExitCode plan_command(const PlanOptions& options);

}  // namespace clevis::app
