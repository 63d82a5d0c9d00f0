#include "elasticity/lanes/thread_team.h"

#include <algorithm>

namespace clevis::elasticity {

ThreadTeam::ThreadTeam(int threads) {
  for (int t = 1; t < threads; ++t) {
    workers_.emplace_back([this] {
      work();
    });
  }
}

ThreadTeam::~ThreadTeam() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  start_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void ThreadTeam::take_tasks() {
  for (int i = next_++; i < tasks_; i = next_++) (*task_)(i);
}

void ThreadTeam::run(int tasks, const std::function<void(int)>& task) {
  {
    const std::lock_guard lock(mutex_);
    task_ = &task;
    tasks_ = tasks;
    next_ = 0;
    working_ = static_cast<int>(workers_.size());
    ++round_;
  }
  start_.notify_all();
  take_tasks();
  std::unique_lock lock(mutex_);
  finish_.wait(lock, [this] {
    return working_ == 0;
  });
}

void ThreadTeam::work() {
  unsigned done = 0;
  for (;;) {
    {
      std::unique_lock lock(mutex_);
      start_.wait(lock, [&] {
        return stop_ || round_ != done;
      });
      if (stop_) return;
      done = round_;
    }
    take_tasks();
    const std::lock_guard lock(mutex_);
    if (--working_ == 0) finish_.notify_one();
  }
}

int machine_threads() {
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

}  // namespace clevis::elasticity
