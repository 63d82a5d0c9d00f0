#pragma once

#include <filesystem>

#include "base/exit_code.h"

namespace clevis::app {

/// Tells the results of a plan, and writes them as table and figure beside it.
/// @throws Error I002, I003, I007.
ExitCode collect_command(const std::filesystem::path& folder);

}  // namespace clevis::app
