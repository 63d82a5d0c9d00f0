#include "app/watch/watch_process.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <iostream>
#include <thread>

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/messages/errors.h"
#include "base/system/interrupts.h"

namespace clevis::app {
namespace {

constexpr std::chrono::milliseconds kPatience(2000);

/// The child's life.
[[noreturn]] void live(const std::function<ExitCode()>& run,
                       const std::filesystem::path& temporary, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
  take_interrupts_as_they_come();
  const sigset_t signals = interrupt_set();
  sigprocmask(SIG_UNBLOCK, &signals, nullptr);
  setenv("TMPDIR", temporary.c_str(), 1);
  const ExitCode code = run();
  std::cout.flush();
  std::cerr.flush();
  _exit(static_cast<int>(code));  // no destructors of what the parent owns
}

}  // namespace

StopSignals::StopSignals() : signals_(interrupt_set()) {
  sigprocmask(SIG_BLOCK, &signals_, &before_);
}

StopSignals::~StopSignals() {
  // One that came meanwhile has been answered.
  while (came_within(std::chrono::milliseconds(0))) {
  }
  sigprocmask(SIG_SETMASK, &before_, nullptr);
}

bool StopSignals::came_within(std::chrono::milliseconds time) const {
  const timespec wait{time.count() / 1000, time.count() % 1000 * 1'000'000};
  return sigtimedwait(&signals_, nullptr, &wait) > 0;
}

WatchProcess::WatchProcess(const std::function<ExitCode()>& run,
                           const std::filesystem::path& temporary) {
  std::cout.flush();
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ < 0) {
    process_ = 0;
    throw Error(
        "I002", "--watch",
        std::string("no process could be started: ") + std::strerror(errno),
        "Close other programs and try again.");
  }
  if (process_ == 0) live(run, temporary, parent);
}

WatchProcess::~WatchProcess() {
  stop();
}

bool WatchProcess::has_ended() {
  if (process_ == 0) return true;
  int status = 0;
  const pid_t ended = waitpid(process_, &status, WNOHANG);
  if (ended == 0 || (ended < 0 && errno == EINTR)) return false;
  process_ = 0;
  if (ended > 0 && WIFSIGNALED(status)) {
    ending_ = fmt::format("the check was ended by signal {} ({})",
                          WTERMSIG(status), strsignal(WTERMSIG(status)));
  }
  return true;
}

void WatchProcess::stop() {
  constexpr std::chrono::milliseconds kPause(5);
  if (has_ended()) return;
  kill(process_, SIGTERM);
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  while (!has_ended()) {
    if (std::chrono::steady_clock::now() > deadline) kill(process_, SIGKILL);
    std::this_thread::sleep_for(kPause);
  }
}

}  // namespace clevis::app
