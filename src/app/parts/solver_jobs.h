#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/processes/worker_pool.h"
#include "app/request/options.h"
#include "app/scenes/load_scene.h"
#include "assessment/job/part_job.h"
#include "base/messages/errors.h"
#include "calculix/model.h"

namespace clevis::app {

/// A scene with what must be solved for the parts that are asked for.
struct SolverJobs {
  LoadedScene loaded;
  std::vector<assessment::PartJob> jobs;
};

/// Moves the scene's mechanism and loads its parts; a blow is computed in time
/// and becomes the static load that stresses the part as much.
/// @throws Error as load_scene, simulate and part_jobs.
SolverJobs load_solver_jobs(const Options& options, scene::Scene read);

/// Something that runs in a process of its own and answers with a text.
struct SolverTask {
  std::string what;  ///< for the progress: "solving AB, 3-D, p = 3"
  std::function<std::string()> run;
};

/// Text, or error; neither: interrupted.
struct SolverAnswer {
  std::optional<std::string> text;
  std::optional<Error> error;
};

/// Runs the tasks one after the other, so that none disturbs the times of
/// another, with progress on stderr. Errors and crashes become answers.
std::vector<SolverAnswer> run_solver_tasks(
    const std::vector<SolverTask>& tasks);

calculix::Hexahedron hexahedron_of(const Options& options);

}  // namespace clevis::app
