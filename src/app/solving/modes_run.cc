#include "app/solving/modes_run.h"

#include <algorithm>
#include <iostream>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "app/parts/part_modes.h"
#include "app/parts/solver_jobs.h"
#include "app/processes/folder_lock.h"
#include "app/ranks/rank_jobs.h"
#include "app/request/output_folder.h"
#include "app/scenes/load_scene.h"
#include "base/system/interrupts.h"
#include "base/system/mpi_run.h"
#include "report/text/atomic_file.h"
#include "report/text/json_text.h"
#include "report/text/text_table.h"

namespace clevis::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

void require_known(const LoadedScene& loaded, const Options& options) {
  std::vector<std::string> known;
  for (const auto& part : loaded.parts) known.push_back(part.definition.name);
  for (const auto& name : options.parts) {
    if (std::ranges::find(known, name) != known.end()) continue;
    throw Error("U001", "--part",
                fmt::format("the scene has no part \"{}\"", name),
                fmt::format("Its parts: {}.", fmt::join(known, ", ")));
  }
  if (!known.empty()) return;
  throw Error("S003", options.scene.string() + ":1:1",
              "the scene has no [[part]]", "Add one with a mesh or geometry.");
}

/// Frequencies have no shared solver: other ranks would wait in silence.
void require_alone(const LoadedPart& part) {
  if (mpi_ranks() == 1 || !pays_to_share(part.mesh)) return;
  throw Error(
      "F005", "part " + part.definition.name,
      fmt::format("ranks of MPI cannot share its frequencies ({} cells)",
                  part.mesh.cells.size()),
      "Run clevis modes without mpirun, or with --part the smaller "
      "parts alone.");
}

std::vector<SolverTask> tasks_of(const LoadedScene& loaded,
                                 const Options& options,
                                 const fs::path& folder) {
  constexpr double kTolerance = 0.01;
  std::vector<SolverTask> tasks;
  for (const auto& part : loaded.parts) {
    const std::string& name = part.definition.name;
    if (!options.parts.empty() &&
        std::ranges::find(options.parts, name) == options.parts.end()) {
      continue;
    }
    require_alone(part);
    for (ModesRequest& request : modes_requests(
             part, loaded.body_of(name) != mechanism::kGround, options.modes,
             options.tolerance.value_or(kTolerance))) {
      request.max_dofs = options.max_dofs;
      tasks.push_back({fmt::format("modes of {}, {}", name, request.supports),
                       [&part, request, folder] {
                         return part_modes(part, request, folder).dump();
                       }});
    }
  }
  return tasks;
}

std::string table_of(const ordered_json& parts, const ordered_json& failures) {
  using enum report::Align;
  report::TextTable table({{"part"},
                           {"supports"},
                           {"model"},
                           {"mode", kRight},
                           {"Hz", kRight},
                           {"change", kRight},
                           {"x %", kRight},
                           {"y %", kRight},
                           {"z %", kRight}});
  const auto percent = [](const ordered_json& value) {
    return fmt::format("{:.1f}", 100.0 * value.get<double>());
  };
  for (const auto& part : parts) {
    int rigid = 0;
    for (const auto& mode : part["modes"]) {
      if (mode["kind"] == "rigid") {
        ++rigid;
        continue;
      }
      table.add_row(
          {{part["part"]},
           {part["supports"]},
           {part["model"]},
           {std::to_string(mode["mode"].get<int>())},
           {fmt::format("{:.5g}", mode["frequency_hz"].get<double>())},
           {fmt::format("{:.1g} %", 100.0 * mode["change"].get<double>())},
           {percent(mode["participation_x"])},
           {percent(mode["participation_y"])},
           {percent(mode["participation_z"])}});
    }
    table.add_note(
        fmt::format("    {}{:.4g} kg, p = {}, {} unknowns, {:.2f} s{}",
                    rigid > 0 ? fmt::format("{} rigid modes; ", rigid) : "",
                    part["mass_kg"].get<double>(), part["degree"].get<int>(),
                    part["equations"].get<int>(), part["seconds"].get<double>(),
                    part["converged"].get<bool>() ? "" : "; not settled"));
  }
  for (const auto& failure : failures) {
    table.add_note(fmt::format("{}: not computed: {} {}",
                               failure["what"].get<std::string>(),
                               failure["problem"].get<std::string>(),
                               failure["remedy"].get<std::string>()));
  }
  return table.text(report::colour_of(STDOUT_FILENO));
}

ordered_json failure_of(const SolverTask& task, const Error& error) {
  return {{"what", task.what},
          {"code", error.code()},
          {"place", error.place()},
          {"problem", error.problem()},
          {"remedy", error.remedy()},
          {"exit_code", static_cast<int>(error.exit_code())}};
}

}  // namespace

ExitCode run_modes(const Options& options, scene::Scene scene) {
  const LoadedScene loaded = load_scene(std::move(scene));
  require_known(loaded, options);
  const fs::path folder =
      options.out.empty() ? output_folder(options) / "modes" : options.out;
  const FolderLock lock(folder);
  const auto tasks = tasks_of(loaded, options, folder);
  const InterruptGuard guard;
  const auto answers = run_solver_tasks(tasks);
  report::remove_unfinished(folder);
  ordered_json parts = ordered_json::array();
  ordered_json failures = ordered_json::array();
  ExitCode outcome = ExitCode::kPass;
  for (std::size_t t = 0; t < tasks.size(); ++t) {
    if (answers[t].text) {
      parts.push_back(ordered_json::parse(*answers[t].text));
    } else if (answers[t].error) {
      if (failures.empty()) outcome = answers[t].error->exit_code();
      failures.push_back(failure_of(tasks[t], *answers[t].error));
    } else {
      outcome = kInterruptedExit;
    }
  }
  const std::string document =
      report::json_text({{"schema", report::kSchema},
                         {"version", CLEVIS_VERSION},
                         {"scene", loaded.scene.name},
                         {"complete", outcome != kInterruptedExit},
                         {"parts", parts},
                         {"failures", failures}});
  report::write_file(folder / "modes.json", document);
  if (options.json) {
    std::cout << document;
  } else {
    std::cout << table_of(parts, failures) << "\nfiles: " << folder.string()
              << "\n";
  }
  return outcome;
}

}  // namespace clevis::app
