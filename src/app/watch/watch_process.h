#pragma once

#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <string>

#include <sys/types.h>

#include "base/messages/exit_code.h"

namespace clevis::app {

/// Keeps SIGINT, SIGTERM and SIGHUP from ending the process while it lives, so
/// that it can be waited for them.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// Waits for one of them. @return whether one came.
  bool came_within(std::chrono::milliseconds time) const;

 private:
  sigset_t signals_{}, before_{};
};

/// A function that runs in a process of its own, which ends with this one.
class WatchProcess {
 public:
  /// @param temporary  folder for its temporary files.
  /// @throws Error I002 if no process can be started.
  WatchProcess(const std::function<ExitCode()>& run,
               const std::filesystem::path& temporary);
  ~WatchProcess();
  WatchProcess(const WatchProcess&) = delete;
  WatchProcess& operator=(const WatchProcess&) = delete;

  bool has_ended();

  /// Interrupts it, and kills it if that takes longer than two seconds.
  void stop();

  /// How it ended, if not by itself: "the check was ended by signal 11 (…)".
  const std::string& ending() const { return ending_; }

 private:
  pid_t process_{};  // 0: has ended
  std::string ending_;
};

}  // namespace clevis::app
