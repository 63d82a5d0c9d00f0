#include "app/commands/mesh_command.h"

#include <iostream>

#include "app/scenes/mesh_parts.h"

namespace clevis::app {

ExitCode mesh_command(const Options& options) {
  if (mesh_parts(options, MeshWhich::kAll, std::cout) == 0) {
    std::cout << "no part of the scene has a geometry: nothing to mesh\n";
  }
  return ExitCode::kPass;
}

}  // namespace clevis::app
