#include "app/parts/solver_jobs.h"

#include <utility>

#include <fmt/format.h>

#include "app/parts/link_compliance.h"
#include "app/parts/part_jobs.h"
#include "app/request/error_text.h"
#include "assessment/impact/impact_check.h"
#include "base/system/system_failure.h"
#include "loads/parts/part_loads.h"
#include "mechanism/simulate.h"
#include "report/text/progress.h"

namespace clevis::app {
namespace {

constexpr char kText = 'T';
constexpr char kRefusal = 'E';

std::string answer_of(const SolverTask& task) {
  try {
    return kText + task.run();
  } catch (const Error& error) {
    return kRefusal + encode_error(error);
  } catch (const std::exception& failure) {
    return kRefusal + encode_error(system_failure(failure, task.what));
  }
}

SolverAnswer decode(const WorkerOutcome& outcome, const SolverTask& task) {
  using enum WorkerOutcome::Kind;
  if (outcome.kind == kInterrupted) return {};
  if (outcome.kind == kDied || outcome.text.empty()) {
    return {std::nullopt, error_of(outcome, task.what)};
  }
  const std::string content = outcome.text.substr(1);
  if (outcome.text.front() == kText) return {content, std::nullopt};
  return {std::nullopt, decode_error(content)};
}

}  // namespace

SolverJobs load_solver_jobs(const Options& options, scene::Scene read) {
  SolverJobs result;
  result.loaded = load_scene(std::move(read));
  add_link_compliances(result.loaded);
  const scene::Scene& scene = result.loaded.scene;
  mechanism::Motion motion;
  if (scene.has_mechanism) {
    mechanism::SimulationSettings settings = scene.simulation;
    settings.max_time = options.max_time.value_or(settings.max_time);
    motion =
        loads::loading_motion(mechanism::simulate(scene.mechanism, settings));
  }
  result.jobs = part_jobs(result.loaded, motion, options.parts,
                          scene.peak_stress_tolerance);
  for (auto& job : result.jobs) job.max_dofs = options.max_dofs;
  // Of a blow the static load that stresses the part as much, as a case.
  for (auto& job : result.jobs) {
    assessment::add_blows_at_rest(job);
    job.impacts.clear();
  }
  return result;
}

std::vector<SolverAnswer> run_solver_tasks(
    const std::vector<SolverTask>& tasks) {
  report::Progress progress;
  const auto outcomes = run_workers(
      tasks.size(), 1,
      [&](std::size_t index) {
        return answer_of(tasks[index]);
      },
      [&](std::size_t done, const std::vector<std::size_t>& running) {
        progress.update(static_cast<int>(done), static_cast<int>(tasks.size()),
                        running.empty() ? "" : tasks[running.front()].what);
      });
  progress.clear();
  std::vector<SolverAnswer> answers;
  for (std::size_t t = 0; t < tasks.size(); ++t) {
    answers.push_back(decode(outcomes[t], tasks[t]));
  }
  return answers;
}

calculix::Hexahedron hexahedron_of(const Options& options) {
  return options.elements == "C3D20" ? calculix::Hexahedron::kFull
                                     : calculix::Hexahedron::kReduced;
}

}  // namespace clevis::app
