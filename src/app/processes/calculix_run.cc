#include "app/processes/calculix_run.h"

#include <chrono>
#include <fstream>
#include <iterator>
#include <sstream>

#include <fmt/format.h>

#include "app/processes/child_process.h"
#include "app/processes/displacement_match.h"
#include "app/processes/temporary_folder.h"
#include "base/messages/errors.h"
#include "calculix/deck.h"
#include "calculix/frd.h"
#include "mesh/derived/split_cells.h"
#include "stress/field/stress_history.h"
#include "study/clevis_run.h"

namespace clevis::app {
namespace {

namespace fs = std::filesystem;
using assessment::PartJob;

constexpr std::chrono::minutes kTimeout(15);

std::string read_text(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

ChildOutcome run_ccx(const std::vector<std::string>& arguments,
                     const fs::path& folder) {
  std::vector<std::string> all = {"ccx"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return run_child(
      {.arguments = all,
       .folder = folder,
       .log = folder / "ccx.log",
       .environment = {"OMP_NUM_THREADS=1", "OPENBLAS_NUM_THREADS=1"}},
      kTimeout);
}

/// The last words of ccx, for a message.
std::string complaint(const std::string& log) {
  std::istringstream lines(log);
  std::string found = "no message";
  for (std::string line; std::getline(lines, line);) {
    if (line.find("*ERROR") != std::string::npos) return line;
    if (!line.empty()) found = line;
  }
  return found;
}

loads::LoadHistory history_of(const PartJob& job,
                              const CalculixRequest& request) {
  loads::LoadHistory history = job.load_sets.front().history;
  if (!request.every_instant) {
    history.instants = {
        history.instants[static_cast<std::size_t>(request.instant)]};
  }
  return history;
}

/// The fastest of a few runs, as study::solve_model does.
ChildOutcome fastest_run(const fs::path& folder) {
  constexpr double kRepeatSeconds = 0.3;
  constexpr int kMostRepeats = 5;
  ChildOutcome best;
  double spent = 0.0;
  for (int k = 0; k < kMostRepeats && spent < kRepeatSeconds; ++k) {
    const ChildOutcome outcome = run_ccx({"-i", "part"}, folder);
    spent += outcome.seconds;
    if (k == 0 || outcome.cpu_seconds < best.cpu_seconds) best = outcome;
    if (!outcome.succeeded()) return outcome;
  }
  return best;
}

}  // namespace

std::optional<std::string> calculix_version() {
  const TemporaryFolder folder;
  const ChildOutcome outcome = run_ccx({"-v"}, folder.path());
  const std::string log = read_text(folder.path() / "ccx.log");
  constexpr std::string_view kVersion = "Version ";
  const auto at = log.find(kVersion);
  if (!outcome.was_found() || at == std::string::npos) return std::nullopt;
  const auto begin = at + kVersion.size();
  return "CalculiX " +
         log.substr(begin, log.find_first_of(" \n", begin) - begin);
}

std::string calculix_setting(int split) {
  return split == 1 ? "h" : fmt::format("h/{}", split);
}

double calculix_dofs(const mesh::PartMesh<3>& mesh, int split) {
  if (mesh.shape == mesh::CellShape::kSimplex) {
    return 3.0 * 2.0 * static_cast<double>(mesh.cells.size());
  }
  // Per hexahedron at least one vertex and three mid nodes, on thin plates
  // about twice that.
  return 3.0 * 6.0 * static_cast<double>(mesh.cells.size()) * split * split *
         split;
}

study::Run run_calculix(const PartJob& job, const CalculixRequest& request) {
  const auto& set = job.load_sets.front();
  const loads::LoadHistory history = history_of(job, request);
  const bool is_tensor = job.mesh.shape == mesh::CellShape::kTensor;
  const auto mesh =
      is_tensor ? mesh::split_cells(job.mesh, request.split) : job.mesh;
  elasticity::ElasticProblem<3> problem{mesh, job.part.material, history,
                                        set.fixed, job.part.name};
  problem.foundations = set.foundations;
  const auto model = calculix::make_model(problem, request.hexahedron);
  const TemporaryFolder folder;
  {
    std::ofstream deck(folder.path() / "part.inp");
    calculix::write_deck(deck, model);
    if (!deck.flush()) {
      throw Error("I002", (folder.path() / "part.inp").string(),
                  "the deck could not be written", "Free space for it.");
    }
  }
  const ChildOutcome outcome = fastest_run(folder.path());
  if (!outcome.succeeded()) {
    throw Error(
        "I004", "part " + job.part.name,
        outcome.status
            ? "ccx failed: " + complaint(read_text(folder.path() / "ccx.log"))
            : fmt::format("ccx did not finish within {} min", kTimeout.count()),
        "Export the deck and run it by hand.");
  }
  std::ifstream answer(folder.path() / "part.frd");
  const auto steps = calculix::read_frd(
      answer, static_cast<int>(model.nodes.cols()), "part.frd");
  const std::size_t step =
      request.every_instant ? static_cast<std::size_t>(request.instant) : 0;
  if (steps.size() != history.instants.size()) {
    throw Error("I004", "part " + job.part.name,
                fmt::format("{} steps of {} in the .frd", steps.size(),
                            history.instants.size()),
                "Export the deck and run it by hand.");
  }
  study::Run run;
  run.series = "CalculiX " + model.element;
  run.setting = calculix_setting(request.split);
  run.dofs = model.dofs();
  run.peak = stress::von_mises(steps[step].stress.transpose()).maxCoeff();
  run.energy = calculix::strain_energy(model, static_cast<int>(step),
                                       steps[step].displacement);
  run.seconds.total = outcome.seconds;
  run.cpu_seconds = outcome.cpu_seconds;
  run.memory = outcome.peak_memory;
  // A part with plane models alone has nothing to compare with.
  const auto finest = study::series_of(job).back().model;
  if (assessment::traits_of(finest).dim == 3) {
    run.displacement_difference =
        displacement_difference(job, history, model, request.split, steps);
  }
  return run;
}

}  // namespace clevis::app
