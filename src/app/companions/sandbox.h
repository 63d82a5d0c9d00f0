#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace clevis::app {

/// What stands before a companion's command so that bubblewrap runs it: it sees
/// the system's libraries, its own program and its input, to read, and its
/// working folder; no network, no other process, no other program.
/// @param input   files that it reads.
/// @param folder  that it writes into.
/// @return nothing where bwrap is not installed or may not be used here, which
///   is tried once.
std::vector<std::string> sandbox_command(
    const std::filesystem::path& program,
    const std::vector<std::filesystem::path>& input,
    const std::filesystem::path& folder);

/// Whether there is one, for `clevis doctor`.
std::string about_sandbox();

}  // namespace clevis::app
