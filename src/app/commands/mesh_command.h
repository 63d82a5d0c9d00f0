#pragma once

#include "app/request/options.h"
#include "base/exit_code.h"

namespace clevis::app {

/// Meshes the parts' geometries by gmsh, each in a process of its own.
/// @throws Error of what gmsh said, with the geometry as place.
ExitCode mesh_command(const Options& options);

}  // namespace clevis::app
