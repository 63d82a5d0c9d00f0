#include "app/plugin/modes_command.h"

#include <memory>

#include <CLI/CLI.hpp>

#include "app/plugin/solver_library.h"
#include "app/solving/plugin_entries.h"

namespace clevis::app {

ExitCode modes_command(const Options& options) {
  return run_in_plugin(kModesEntryName, options);
}

Run declare_modes(CLI::App& command) {
  constexpr int kMostModes = 200;
  command.footer(
      "A part that the mechanism moves vibrates free, with 6 rigid modes; a\n"
      "case's supports give modes of their own. Shapes (VTU) and modes.json "
      "go\n"
      "to --out [results/<scene>/modes].");
  const auto request = std::make_shared<SceneRequest>();
  Options& options = request->options;
  add_scene(command, *request);
  add_parts(command, options.parts);
  command
      .add_option("--modes", options.modes,
                  "how many per part, rigid ones counted in [12]")
      ->type_name("N")
      ->check(CLI::Range(1, kMostModes));
  command
      .add_option("--tolerance", request->tolerance,
                  "of the frequencies, e.g. 1%")
      ->type_name("RATIO");
  add_max_dofs(command, options,
               "degrees of freedom that a solution may have: higher degrees "
               "are left out, and the frequencies not settled [what memory "
               "holds]");
  add_output(command, options);
  return run_request(request, modes_command);
}

}  // namespace clevis::app
