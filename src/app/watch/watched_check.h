#pragma once

#include <functional>

#include "app/request/options.h"
#include "base/messages/exit_code.h"

namespace clevis::app {

/// Runs the check in a process of its own, with outdated meshes made first, and
/// again whenever a file that it reads has changed, until SIGINT, SIGTERM or
/// SIGHUP. A change during a run stops that one. Errors are told, and the
/// next change is waited for.
/// @param check  one run.
/// @return kInterruptedExit.
/// @throws Error I001 if there is no such scene to begin with, I002 if there
///   can be no process or temporary folder.
ExitCode watched_check(const Options& options,
                       const std::function<ExitCode(const Options&)>& check);

}  // namespace clevis::app
