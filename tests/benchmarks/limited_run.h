#pragma once

#include <cstdio>
#include <functional>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace clevis::benchmarks {

/// Does a work that may never end in a process of its own.
///
/// @param seconds  of the processor that it gets [s].
/// @returns whether it came to an end.
inline bool finishes(int seconds, const std::function<void()>& work) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    const auto most = static_cast<rlim_t>(seconds);
    const rlimit limit{most, most};
    setrlimit(RLIMIT_CPU, &limit);
    work();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status);
}

}  // namespace clevis::benchmarks
