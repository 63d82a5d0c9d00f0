#pragma once

#include "app/request/options.h"
#include "base/messages/exit_code.h"
#include "scene/scene.h"

namespace clevis::app {

/// Checks the parts of the scene, each in a process of its own: table or JSON
/// on stdout, files in the output folder.
/// @throws Error as load_scene, simulate and part_jobs.
ExitCode run_check(const Options& options, scene::Scene scene);

}  // namespace clevis::app
