#pragma once

#include "app/request/command_options.h"
#include "app/request/options.h"
#include "base/messages/exit_code.h"

namespace clevis::app {

/// Meshes the parts' geometries by gmsh, each in a process of its own.
/// @throws Error of what gmsh said, with the geometry as place.
ExitCode mesh_command(const Options& options);

/// Declares the options of `clevis mesh`. @return what runs it.
Run declare_mesh(CLI::App& command);

}  // namespace clevis::app
