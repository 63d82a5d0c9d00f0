#pragma once

#include <csignal>
#include <functional>
#include <string>
#include <vector>

namespace clevis::app {

/// Notes SIGINT and SIGTERM while it lives, also those that were blocked
/// until now, instead of dying: run_workers() then stops, so that the command
/// can still tell what it has.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

 private:
  struct sigaction old_interrupt_ {
  }, old_terminate_{};
};

/// Outcome of a task.
struct WorkerOutcome {
  enum class Kind { kDone, kDied, kInterrupted };
  Kind kind = Kind::kInterrupted;
  std::string text;  ///< what the task returned, or how its process ended
};

/// Runs tasks in processes of their own, `jobs` at a time, in the given
/// order. A crash takes down one task only; nothing is shared. Tasks die with
/// the parent, however it ends.
///
/// An interrupt (InterruptGuard) stops all workers; tasks that had not
/// returned are kInterrupted.
/// @param task      runs in the child; its text comes back.
/// @param progress  called in the parent whenever something changed: number
///   of tasks done, indices of those running.
std::vector<WorkerOutcome> run_workers(
    std::size_t tasks, int jobs,
    const std::function<std::string(std::size_t)>& task,
    const std::function<void(std::size_t, const std::vector<std::size_t>&)>&
        progress);

}  // namespace clevis::app
