#include "app/plugin/check_command.h"

#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/plugin/solver_library.h"
#include "app/scenes/mesh_parts.h"
#include "app/solving/plugin_entries.h"
#include "app/variants/finished_check.h"
#include "app/watch/watched_check.h"
#include "assessment/job/model_traits.h"
#include "base/messages/errors.h"
#include "base/system/mpi_run.h"

namespace clevis::app {
namespace {

std::string about_models() {
  std::string text =
      "auto takes the cheapest model that suits a part and meets the "
      "tolerance:";
  for (const auto& model : assessment::kModels) {
    text += fmt::format("\n  {:<13} {}", model.word, model.suits);
  }
  return text;
}

}  // namespace

ExitCode check_command(const Options& options) {
  if (options.mesh && mpi_ranks() > 1) {
    throw Error("U001", "--mesh", "several ranks cannot mesh",
                "Run clevis mesh alone first, with the same --set.");
  }
  try {
    if (options.mesh) mesh_parts(options, MeshWhich::kOutdated, std::cerr);
    if (options.resume) {
      if (const auto code = finished_check(options)) return *code;
    }
    return run_in_plugin(kCheckEntryName, options);
  } catch (const Error& error) {
    // Whoever holds the folder writes there.
    if (options.resume && error.code() != "I006") write_refusal(options, error);
    throw;
  }
}

ExitCode check_or_watch(const Options& options) {
  if (!options.watch) return check_command(options);
  if (mpi_ranks() > 1) {
    throw Error("U001", "--watch", "several ranks cannot watch",
                "Run clevis check --watch without mpirun.");
  }
  load_plugin();  // once for all runs
  return watched_check(options, check_command);
}

Run declare_check(CLI::App& command) {
  const auto request = std::make_shared<SceneRequest>();
  Options& options = request->options;
  add_scene(command, *request);
  add_parts(command, options.parts);
  command
      .add_option("--tolerance", request->tolerance,
                  "of the peak stress, e.g. 1%; replaces the scene's")
      ->type_name("RATIO");
  add_output(command, options);
  add_report_flag(command, options);
  command.add_flag("--linear-vtu", options.linear_vtu,
                   "write NAME_linear.vtu too, for readers without "
                   "higher-order cells");
  add_max_time(command, *request);
  add_max_dofs(command, options,
               "degrees of freedom that a solution of a part may have: higher "
               "degrees and finer meshes are left out [what memory holds]");
  add_jobs(command, options.jobs, "parts in parallel [one per core]");
  add_model(command, options.model);
  add_mesh_flag(command, options);
  constexpr int kMostRounds = 5;
  command
      .add_option("--mesh-rounds", options.mesh_rounds,
                  "finer meshes at most of a STEP part whose band stays open "
                  "[2]")
      ->type_name("N")
      ->check(CLI::Range(0, kMostRounds));
  command
      .add_flag("--resume", options.resume,
                "keep the result in --out if it is whole and of the same "
                "inputs")
      ->excludes("--linear-vtu");
  add_engine(command, options);
  command
      .add_flag("--watch", options.watch,
                "check again, --mesh included, whenever the scene or a file "
                "that it reads changes; an open report.html follows. Ctrl-C "
                "ends it")
      ->excludes("--json")
      ->excludes("--resume");
  command.footer(about_models());
  return run_request(request, check_or_watch);
}

}  // namespace clevis::app
