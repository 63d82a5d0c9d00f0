#include "app/plugin/study_command.h"

#include <memory>

#include <CLI/CLI.hpp>

#include "app/plugin/solver_library.h"
#include "app/solving/plugin_entries.h"
#include "base/messages/errors.h"
#include "base/system/mpi_run.h"

namespace clevis::app {

ExitCode study_command(const Options& options) {
  if (mpi_ranks() > 1) {
    throw Error("U001", "study", "several ranks cannot study",
                "Run clevis study without mpirun: it takes the time of one "
                "process.");
  }
  return run_in_plugin(kStudyEntryName, options);
}

Run declare_study(CLI::App& command) {
  command.footer(
      "Solves each part with every model and degree, one process at a time,\n"
      "and CalculiX's ccx beside them if it is installed. Tables (CSV), plots\n"
      "(SVG) and study.json go to --out.");
  const auto request = std::make_shared<SceneRequest>();
  Options& options = request->options;
  add_scene(command, *request);
  add_parts(command, options.parts);
  add_output(command, options);
  add_elements(command, options);
  add_split(command, options,
            "cut CalculiX's hexahedra into up to N x N x N [6]");
  command.add_flag("--every-instant", options.every_instant,
                   "CalculiX solves all instants, a step for each, not only "
                   "the governing one");
  add_max_dofs(command, options,
               "degrees of freedom that a solution may have: others are left "
               "out [450000, of CalculiX's cut hexahedra 120000]");
  add_engine(command, options);
  return run_request(request, study_command);
}

}  // namespace clevis::app
