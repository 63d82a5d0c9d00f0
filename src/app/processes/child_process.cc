#include "app/processes/child_process.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <thread>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "app/processes/lone_program.h"
#include "base/messages/errors.h"
#include "base/system/allowed_program.h"
#include "base/system/interrupts.h"
#include "base/values/stopwatch.h"

namespace clevis::app {
namespace {

constexpr int kNotStarted = 127;                  // as a shell says it
constexpr rlim_t kLargestFile = rlim_t{1} << 30;  // [bytes]

/// "VALUE\0"-terminated strings as execve wants them.
std::vector<char*> pointers(std::vector<std::string>& strings) {
  std::vector<char*> result;
  for (std::string& text : strings) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

/// Replaces the child process by the program; its output goes to `log`.
/// @param is_alone  it may start no other.
[[noreturn]] void become(const std::string& program, bool is_alone,
                         char* const* arguments, char* const* environment,
                         const Child& child, pid_t parent) {
  setpgid(0, 0);
  std::signal(SIGXFSZ, SIG_DFL);
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // Ctrl-C on clevis ends the child too
  const rlimit size{kLargestFile, kLargestFile};
  setrlimit(RLIMIT_FSIZE, &size);
  if (child.memory) {
    const rlimit space{*child.memory, *child.memory}, none{0, 0};
    setrlimit(RLIMIT_AS, &space);
    setrlimit(RLIMIT_CORE, &none);
  }
  const int in = open("/dev/null", O_RDONLY | O_CLOEXEC);
  const int out = open(child.log.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  if (getppid() == parent && in >= 0 && out >= 0 && dup2(in, 0) == 0 &&
      dup2(out, 1) == 1 && dup2(out, 2) == 2 &&
      chdir(child.folder.c_str()) == 0) {
    if (is_alone) allow_only(program.c_str());
    execve(program.c_str(), arguments, environment);
  }
  _exit(kNotStarted);
}

/// Waits for the child, killed if it takes too long or an interrupt came; what
/// it used.
ChildOutcome wait_for(pid_t child, std::chrono::milliseconds timeout) {
  constexpr std::chrono::milliseconds kPause(5);
  const auto deadline = std::chrono::steady_clock::now() + timeout;
  ChildOutcome outcome;
  rusage usage{};
  int status = 0;
  while (wait4(child, &status, WNOHANG, &usage) == 0) {
    if (std::chrono::steady_clock::now() > deadline || is_interrupted()) {
      kill(-child, SIGKILL);
      wait4(child, &status, 0, &usage);
      return outcome;
    }
    std::this_thread::sleep_for(kPause);
  }
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) +
           1e-6 * static_cast<double>(time.tv_usec);
  };
  outcome.status = status;
  outcome.cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  outcome.peak_memory = 1024.0 * static_cast<double>(usage.ru_maxrss);
  return outcome;
}

}  // namespace

bool ChildOutcome::succeeded() const {
  return status && WIFEXITED(*status) && WEXITSTATUS(*status) == 0;
}

bool ChildOutcome::was_found() const {
  return !status || !WIFEXITED(*status) || WEXITSTATUS(*status) != kNotStarted;
}

ChildOutcome run_child(const Child& child, std::chrono::milliseconds timeout) {
  const char* search = std::getenv("PATH");
  std::vector<std::string> arguments = child.arguments;
  std::vector<std::string> environment = {
      std::string("PATH=") + (search != nullptr ? search : "/usr/bin:/bin"),
      "HOME=" + child.folder.string(), "TMPDIR=" + child.folder.string(),
      "LC_ALL=C"};
  environment.insert(environment.end(), child.environment.begin(),
                     child.environment.end());
  // A script may need others.
  const std::string program = find_program(arguments[0]).string();
  const bool is_alone = is_binary(program) && !child.starts_others;
  const std::vector<char*> argument_list = pointers(arguments);
  const std::vector<char*> environment_list = pointers(environment);
  Stopwatch watch;
  const pid_t parent = getpid();
  const pid_t process = fork();
  if (process < 0) {
    throw Error(
        "I002", arguments[0],
        std::string("no process could be started: ") + std::strerror(errno),
        "Close other programs and try again.");
  }
  if (process == 0) {
    become(program, is_alone, argument_list.data(), environment_list.data(),
           child, parent);
  }
  setpgid(process, process);  // whoever comes first; the other does nothing
  ChildOutcome outcome = wait_for(process, timeout);
  outcome.seconds = watch.lap();
  return outcome;
}

}  // namespace clevis::app
