#include "app/solving/export_run.h"

#include <algorithm>
#include <iostream>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/parts/part_jobs.h"
#include "app/parts/solver_jobs.h"
#include "app/processes/folder_lock.h"
#include "app/request/output_folder.h"
#include "app/scenes/load_scene.h"
#include "base/system/interrupts.h"
#include "calculix/deck.h"
#include "mesh/derived/split_cells.h"
#include "report/text/atomic_file.h"
#include "report/text/json_text.h"

namespace clevis::app {
namespace {

namespace fs = std::filesystem;
using assessment::PartJob;
using nlohmann::ordered_json;

calculix::Model model_of(const PartJob& job, std::size_t set,
                         const Options& options) {
  const bool is_tensor = job.mesh.shape == mesh::CellShape::kTensor;
  const auto mesh =
      is_tensor ? mesh::split_cells(job.mesh, std::max(1, options.split))
                : job.mesh;
  const auto& loads = job.load_sets[set];
  elasticity::ElasticProblem<3> problem{mesh, job.part.material, loads.history,
                                        loads.fixed, job.part.name};
  problem.foundations = loads.foundations;
  return calculix::make_model(problem, hexahedron_of(options));
}

/// Writes a deck per set of loads with the same supports, NAME.inp,
/// NAME_2.inp …; runs in a worker process.
std::string export_part(const PartJob& job, const Options& options,
                        const fs::path& folder) {
  ordered_json decks = ordered_json::array();
  for (std::size_t set = 0; set < job.load_sets.size(); ++set) {
    const auto model = model_of(job, set, options);
    std::ostringstream deck;
    calculix::write_deck(deck, model);
    const fs::path file =
        folder / (set == 0 ? job.part.name + ".inp"
                           : fmt::format("{}_{}.inp", job.part.name, set + 1));
    report::write_file(file, deck.view());
    decks.push_back({{"part", job.part.name},
                     {"file", file.string()},
                     {"elements", model.element},
                     {"cells", model.elements.size()},
                     {"dofs", model.dofs()},
                     {"steps", model.labels.size()}});
  }
  return decks.dump();
}

std::string table_of(const ordered_json& decks) {
  std::string text;
  for (const auto& deck : decks) {
    text += fmt::format(
        "{}: {} {}, {} degrees of freedom, {} {}\n",
        deck["file"].get<std::string>(), deck["cells"].get<int>(),
        deck["elements"].get<std::string>(), deck["dofs"].get<int>(),
        deck["steps"].get<int>(), deck["steps"] == 1 ? "step" : "steps");
  }
  return text;
}

}  // namespace

ExitCode run_export(const Options& options, scene::Scene scene) {
  const fs::path folder = output_folder(options);
  const auto loaded = load_solver_jobs(options, std::move(scene));
  const FolderLock lock(folder);
  const InterruptGuard guard;
  std::vector<SolverTask> tasks;
  for (const auto& job : loaded.jobs) {
    tasks.push_back({"exporting " + job.part.name, [&job, &options, &folder] {
                       return export_part(job, options, folder);
                     }});
  }
  const auto answers = run_solver_tasks(tasks);
  report::remove_unfinished(folder);
  ordered_json decks = ordered_json::array();
  bool is_complete = true;
  for (const auto& answer : answers) {
    if (answer.error) throw *answer.error;
    if (!answer.text) {
      is_complete = false;
      continue;
    }
    for (const auto& deck : ordered_json::parse(*answer.text)) {
      decks.push_back(deck);
    }
  }
  if (options.json) {
    std::cout << report::json_text({{"schema", report::kSchema},
                                    {"complete", is_complete},
                                    {"decks", decks}});
  } else {
    std::cout << table_of(decks);
  }
  return is_complete ? ExitCode::kPass : kInterruptedExit;
}

}  // namespace clevis::app
