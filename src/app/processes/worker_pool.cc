#include "app/processes/worker_pool.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <thread>

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/messages/errors.h"
#include "base/system/interrupts.h"
#include "base/system/system_failure.h"

namespace clevis::app {
namespace {

struct Worker {
  std::size_t task{};
  pid_t process{};
  int pipe{};
  std::string text;
};

void write_all(int file, const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t n = write(file, text.data() + done, text.size() - done);
    if (n < 0 && errno != EINTR) return;  // the parent sees a cut text
    if (n > 0) done += static_cast<std::size_t>(n);
  }
}

Worker start(std::size_t index,
             const std::function<std::string(std::size_t)>& task) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) {
    throw Error("I002", "worker", std::strerror(errno),
                "Free system resources.");
  }
  const pid_t parent = getpid();
  const pid_t process = fork();
  if (process < 0) {
    throw Error("I002", "worker", std::strerror(errno),
                "Free system resources.");
  }
  if (process == 0) {
    // An orphan would go on writing into a folder that others may use by then.
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1);
    end_on_parents_signal();
    close(ends[0]);
    write_all(ends[1], task(index));
    close(ends[1]);
    _exit(0);  // no destructors of what the parent owns
  }
  close(ends[1]);
  return {index, process, ends[0], {}};
}

/// Reads what is there; false at the end of the text.
bool read_some(Worker& worker) {
  std::array<char, 65536> buffer{};
  const ssize_t n = read(worker.pipe, buffer.data(), buffer.size());
  if (n > 0) worker.text.append(buffer.data(), static_cast<std::size_t>(n));
  return n > 0 || (n < 0 && errno == EINTR);
}

WorkerOutcome finish(Worker& worker) {
  close(worker.pipe);
  int status = 0;
  while (waitpid(worker.process, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
    return {WorkerOutcome::Kind::kDone, std::move(worker.text)};
  }
  if (WIFSIGNALED(status)) {
    return {WorkerOutcome::Kind::kDied,
            fmt::format("its process was ended by signal {} ({})",
                        WTERMSIG(status), strsignal(WTERMSIG(status))),
            WTERMSIG(status)};
  }
  return {WorkerOutcome::Kind::kDied,
          fmt::format("its process ended with code {}", WEXITSTATUS(status))};
}

/// Lets the workers end in order, 3 s at most: those that run a child end it
/// and remove its folder, which takes a while on a busy machine.
void stop(std::vector<Worker>& workers) {
  constexpr int kTries = 600;
  constexpr std::chrono::milliseconds kPause(5);
  for (const Worker& worker : workers) kill(worker.process, SIGTERM);
  const auto has_ended = [](const Worker& worker) {
    siginfo_t state{};
    return waitid(P_PID, static_cast<id_t>(worker.process), &state,
                  WEXITED | WNOHANG | WNOWAIT) == 0 &&
           state.si_pid != 0;
  };
  for (int i = 0; i < kTries && !std::ranges::all_of(workers, has_ended); ++i) {
    std::this_thread::sleep_for(kPause);
  }
  for (Worker& worker : workers) {
    kill(worker.process, SIGKILL);
    finish(worker);
  }
  workers.clear();
}

}  // namespace

Error error_of(const WorkerOutcome& outcome, const std::string& place) {
  if (outcome.signal == SIGKILL || outcome.signal == SIGXCPU) {
    return out_of_resources(place, outcome.text);
  }
  return {"X001", place, "it crashed: " + outcome.text,
          "Please report this with the scene and its mesh."};
}

std::vector<WorkerOutcome> run_workers(
    std::size_t tasks, int jobs,
    const std::function<std::string(std::size_t)>& task,
    const std::function<void(std::size_t, const std::vector<std::size_t>&)>&
        progress) {
  constexpr int kPollMilliseconds = 200;
  std::vector<WorkerOutcome> outcomes(tasks);
  std::vector<Worker> workers;
  std::size_t next = 0;
  std::size_t done = 0;
  while (!is_interrupted() && (next < tasks || !workers.empty())) {
    while (next < tasks && workers.size() < static_cast<std::size_t>(jobs)) {
      workers.push_back(start(next++, task));
    }
    std::vector<std::size_t> running;
    std::vector<pollfd> pipes;
    for (const Worker& worker : workers) {
      running.push_back(worker.task);
      pipes.push_back({worker.pipe, POLLIN, 0});
    }
    progress(done, running);
    if (poll(pipes.data(), pipes.size(), kPollMilliseconds) <= 0) continue;
    for (std::size_t w = workers.size(); w-- > 0;) {
      if (pipes[w].revents == 0 || read_some(workers[w])) continue;
      outcomes[workers[w].task] = finish(workers[w]);
      workers.erase(workers.begin() + static_cast<std::ptrdiff_t>(w));
      ++done;
    }
  }
  stop(workers);
  return outcomes;
}

}  // namespace clevis::app
