#pragma once

#include "app/request/options.h"
#include "base/messages/exit_code.h"
#include "scene/scene.h"

namespace clevis::app {

/// Writes the parts and their loads as CalculiX decks.
/// @throws Error as load_solver_jobs.
ExitCode run_export(const Options& options, scene::Scene scene);

}  // namespace clevis::app
