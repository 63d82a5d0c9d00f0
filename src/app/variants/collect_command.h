#pragma once

#include <filesystem>

#include "app/request/command_options.h"
#include "base/messages/exit_code.h"

namespace clevis::app {

/// Tells the results of a plan, and writes them as table and figure beside it.
/// @throws Error I002, I003, I007.
ExitCode collect_command(const std::filesystem::path& folder);

/// Declares the options of `clevis collect`. @return what runs it.
Run declare_collect(CLI::App& command);

}  // namespace clevis::app
