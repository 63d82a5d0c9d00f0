#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace clevis::elasticity {

/// Threads that wait for work. What a task does must not depend on which
/// thread runs it; then nothing depends on how many there are.
class ThreadTeam {
 public:
  /// @param threads  the caller's own included; at least 1.
  explicit ThreadTeam(int threads);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  /// Calls task(0) … task(tasks − 1), each once, and returns when all have.
  /// @pre task throws nothing.
  void run(int tasks, const std::function<void(int)>& task);

  int threads() const { return static_cast<int>(workers_.size()) + 1; }

 private:
  void work();
  void take_tasks();

  std::vector<std::thread> workers_;
  std::mutex mutex_;
  std::condition_variable start_, finish_;
  const std::function<void(int)>* task_ = nullptr;
  std::atomic<int> next_{0};
  int tasks_{};
  int working_{};     ///< workers that have not finished this round
  unsigned round_{};  ///< of run()
  bool stop_ = false;
};

/// Threads of this machine.
int machine_threads();

}  // namespace clevis::elasticity
