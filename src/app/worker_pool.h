#pragma once

#include <functional>
#include <string>
#include <vector>

namespace clevis::app {

/// What became of a task.
struct WorkerOutcome {
  enum class Kind { kDone, kDied, kInterrupted };
  Kind kind = Kind::kInterrupted;
  std::string text;  ///< what the task returned, or how its process ended
};

/// Runs tasks in processes of their own, `jobs` at a time, in the given
/// order. A crash takes down one task only; nothing is shared.
///
/// SIGINT and SIGTERM stop all workers; tasks that had not returned are
/// kInterrupted.
/// @param task      runs in the child; its text comes back.
/// @param progress  called in the parent whenever something changed: number
///   of tasks done, indices of those running.
std::vector<WorkerOutcome> run_workers(
    std::size_t tasks, int jobs,
    const std::function<std::string(std::size_t)>& task,
    const std::function<void(std::size_t, const std::vector<std::size_t>&)>&
        progress);

}  // namespace clevis::app
