#include "app/plugin/export_command.h"

#include <memory>

#include <CLI/CLI.hpp>

#include "app/plugin/solver_library.h"
#include "app/results/glb_command.h"
#include "app/solving/plugin_entries.h"

namespace clevis::app {

ExitCode export_command(const Options& options) {
  return options.glb ? glb_command(options)
                     : run_in_plugin(kExportEntryName, options);
}

Run declare_export(CLI::App& command) {
  command.footer(
      "Without --glb a deck per part, one step per instant. With --glb the "
      "moving,\ncoloured parts of a check that has run as mechanism.glb; SCENE "
      "may be the\nfolder of its result.");
  const auto request = std::make_shared<SceneRequest>();
  Options& options = request->options;
  add_scene(command, *request);
  add_parts(command, options.parts);
  add_output(command, options);
  add_elements(command, options);
  add_split(command, options, "cut each hexahedron into N x N x N [1]");
  command.add_flag("--glb", options.glb,
                   "write mechanism.glb from the result of the check");
  return run_request(request, export_command);
}

}  // namespace clevis::app
