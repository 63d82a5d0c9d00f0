#include "app/commands/mesh_command.h"

#include <iostream>

#include <CLI/CLI.hpp>

#include "app/scenes/mesh_parts.h"

namespace clevis::app {

ExitCode mesh_command(const Options& options) {
  if (mesh_parts(options, MeshWhich::kAll, std::cout) == 0) {
    std::cout << "no part of the scene has a geometry: nothing to mesh\n";
  }
  return ExitCode::kPass;
}

Run declare_mesh(CLI::App& command) {
  command.footer(
      "Runs gmsh on the .geo files that the scene names. A .geo can run shell\n"
      "commands: mesh only scenes that you trust. No other command runs them,\n"
      "but `check` with --mesh or --watch; they read the .msh. STEP, IGES and\n"
      "BREP files run nothing: every command that needs their meshes makes "
      "them.");
  const auto request = std::make_shared<SceneRequest>();
  add_scene(command, *request);
  add_parts(command, request->options.parts);
  return run_request(request, mesh_command);
}

}  // namespace clevis::app
