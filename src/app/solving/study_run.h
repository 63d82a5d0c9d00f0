#pragma once

#include "app/request/options.h"
#include "base/messages/exit_code.h"
#include "scene/scene.h"

namespace clevis::app {

/// Runs every model at every degree, and CalculiX where it is installed: error
/// against time.
/// @throws Error as load_solver_jobs.
ExitCode run_study(const Options& options, scene::Scene scene);

}  // namespace clevis::app
