#include "app/companions/companion_answer.h"

#include <csignal>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <sys/wait.h>

#include "app/companions/sandbox.h"
#include "app/processes/child_process.h"
#include "base/messages/errors.h"
#include "base/system/companion.h"

namespace clevis::app {
namespace {

namespace fs = std::filesystem;

/// bubblewrap tells of a program that a signal ended as a shell does.
void take_signal(ChildOutcome& outcome) {
  constexpr int kSignal = 128;
  if (!outcome.status || !WIFEXITED(*outcome.status)) return;
  const int code = WEXITSTATUS(*outcome.status);
  if (code > kSignal) outcome.status = code - kSignal;
}

/// @throws Error if the companion did not come to an answer.
void require_end(const ChildOutcome& outcome, const Companion& companion,
                 const fs::path& file) {
  const auto refuse = [&](const std::string& problem, const char* remedy) {
    throw Error(companion.code, file.string(), problem, remedy);
  };
  if (!outcome.was_found()) {
    refuse(fmt::format("{} could not be started", companion.name),
           "Reinstall clevis: this program belongs to it.");
  }
  if (!outcome.status) {
    refuse(
        fmt::format("the {} did not finish within {:.3g} s", companion.role,
                    std::chrono::duration<double>(companion.timeout).count()),
        companion.remedy);
  }
  if (outcome.succeeded()) return;
  if (WIFEXITED(*outcome.status) &&
      WEXITSTATUS(*outcome.status) == int(ExitCode::kResourceLimit)) {
    refuse(fmt::format("the {} needs more memory for this file than its limit "
                       "of {} MiB",
                       companion.role, companion.memory >> 20),
           companion.remedy);
  }
  const std::string limit =
      fmt::format("{} MiB are its limit", companion.memory >> 20);
  if (WIFSIGNALED(*outcome.status)) {
    refuse(fmt::format("the {} died of signal {} ({}) on this file",
                       companion.role, WTERMSIG(*outcome.status), limit),
           companion.remedy);
  }
  refuse(fmt::format("the {} gave up on this file; {}", companion.role, limit),
         companion.remedy);
}

}  // namespace

std::string companion_answer(const Companion& companion, const fs::path& file,
                             const fs::path& question, const fs::path& folder) {
  const fs::path answer = folder / "answer.json";
  const fs::path program = companion.program.empty()
                               ? clevis::companion(companion.name)
                               : companion.program;
  std::vector<std::string> arguments =
      sandbox_command(program, {fs::absolute(file)}, folder);
  const bool is_wrapped = !arguments.empty();
  arguments.insert(arguments.end(),
                   {program.string(), question.string(), answer.string()});
  ChildOutcome outcome =
      run_child({.arguments = arguments,
                 .folder = folder,
                 .log = folder / (std::string(companion.role) + ".log"),
                 .memory = companion.memory,
                 .starts_others = is_wrapped},
                companion.timeout);
  if (is_wrapped) take_signal(outcome);
  require_end(outcome, companion, file);
  std::ifstream stream(answer, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void refuse_answer(const Companion& companion, const fs::path& file,
                   const std::exception& failure) {
  throw Error(companion.code, file.string(),
              fmt::format("the {}'s answer cannot be read: {}", companion.role,
                          failure.what()),
              "Please report this with the file.");
}

}  // namespace clevis::app
