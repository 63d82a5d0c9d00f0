#pragma once

#include "app/request/command_options.h"
#include "app/request/options.h"
#include "base/messages/exit_code.h"

namespace clevis::app {

/// Prints one command per variant and writes the plan for `clevis collect`.
/// @throws Error of the first variant that cannot be read, with its place in
///   the table or the scene; I002.
ExitCode plan_command(const PlanOptions& options);

/// Declares the options of `clevis plan`. @return what runs it.
Run declare_plan(CLI::App& command);

}  // namespace clevis::app
