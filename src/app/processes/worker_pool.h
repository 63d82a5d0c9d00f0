#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/messages/errors.h"

namespace clevis::app {

/// Outcome of a task.
struct WorkerOutcome {
  enum class Kind { kDone, kDied, kInterrupted };
  Kind kind = Kind::kInterrupted;
  std::string text;  ///< what the task returned, or how its process ended
  int signal{};      ///< that ended its process, if one did
};

/// Why a task has no text: X002 where the system ended its process (kill,
/// limits), else X001. @param place  of the task.
Error error_of(const WorkerOutcome& outcome, const std::string& place);

/// Runs tasks in processes of their own, `jobs` at a time, in the given
/// order. A crash takes down one task only; nothing is shared. Tasks die with
/// the parent, however it ends.
///
/// An interrupt that an InterruptGuard notes stops all workers; tasks that had
/// not returned are kInterrupted.
/// @param task      runs in the child; its text comes back.
/// @param progress  called in the parent whenever something changed: number
///   of tasks done, indices of those running.
std::vector<WorkerOutcome> run_workers(
    std::size_t tasks, int jobs,
    const std::function<std::string(std::size_t)>& task,
    const std::function<void(std::size_t, const std::vector<std::size_t>&)>&
        progress);

}  // namespace clevis::app
