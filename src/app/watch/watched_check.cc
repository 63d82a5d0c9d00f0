#include "app/watch/watched_check.h"

#include <chrono>
#include <filesystem>
#include <iostream>
#include <string>

#include <fmt/format.h>

#include "app/processes/folder_lock.h"
#include "app/processes/temporary_folder.h"
#include "app/request/error_output.h"
#include "app/request/output_folder.h"
#include "app/watch/report_mark.h"
#include "app/watch/watch_process.h"
#include "app/watch/watched_files.h"
#include "base/messages/errors.h"
#include "base/system/system_failure.h"
#include "report/text/atomic_file.h"
#include "report/text/terminal.h"

namespace clevis::app {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;
using OwnMeshes = WatchedFiles::OwnMeshes;

/// Between two looks. Looking asks for some twenty files' stamps.
constexpr milliseconds kTick(100);

enum class Outcome { kDone, kChanged, kStopped };

void tell(const std::string& text) {
  std::cerr << report::printable(text) << std::endl;
}

void tell_change(const fs::path& file, const char* then) {
  tell(fmt::format("{} changed: {}", file.string(), then));
}

/// Waits until nobody has written for a while: editors replace files, and
/// several saves are one change. A scene that is gone may come back.
Outcome settle(const WatchedFiles& files, const fs::path& scene,
               const StopSignals& signals) {
  constexpr int kQuiet = 3, kQuietWithoutScene = 15;  // ticks
  std::string states = files.states();
  std::error_code ignored;
  for (int quiet = 0;
       quiet < (fs::exists(scene, ignored) ? kQuiet : kQuietWithoutScene);
       ++quiet) {
    if (signals.came_within(kTick)) return Outcome::kStopped;
    std::string now = files.states();
    if (now == states) continue;
    states = std::move(now);
    quiet = -1;
  }
  return Outcome::kChanged;
}

Outcome wait_for_change(const WatchedFiles& files, const fs::path& scene,
                        const StopSignals& signals) {
  for (;;) {
    const fs::path file = files.changed(OwnMeshes::kCount);
    if (!file.empty()) {
      tell_change(file, "checking again");
      return settle(files, scene, signals);
    }
    if (signals.came_within(kTick)) return Outcome::kStopped;
  }
}

/// Lets the run end, unless a file changes or a signal comes.
Outcome wait_for_end(WatchProcess& run, const WatchedFiles& files,
                     const fs::path& scene, const StopSignals& signals) {
  while (!run.has_ended()) {
    if (signals.came_within(kTick)) {
      run.stop();
      return Outcome::kStopped;
    }
    const fs::path file = files.changed(OwnMeshes::kPass);
    if (file.empty()) continue;
    run.stop();
    tell_change(file, "this run is given up, checking again");
    return settle(files, scene, signals);
  }
  return Outcome::kDone;
}

ExitCode told(const Error& error) {
  print_error(error, ErrorFormat::kText);
  return error.exit_code();
}

/// Checks; while another clevis writes into the folder, waits for its end.
ExitCode run_once(const Options& options,
                  const std::function<ExitCode(const Options&)>& check) {
  constexpr std::chrono::minutes kPatience(10);
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  try {
    for (bool has_told = false;; has_told = true) {
      try {
        return check(options);
      } catch (const Error& error) {
        if (error.code() != "I006") throw;
        if (!has_told) {
          tell(fmt::format("{}: {}: it is waited for, {} min at most",
                           error.place(), error.problem(), kPatience.count()));
        }
        const auto rest = std::chrono::duration_cast<milliseconds>(
            deadline - std::chrono::steady_clock::now());
        if (!is_freed_within(output_folder(options), rest)) throw;
      }
    }
  } catch (const Error& error) {
    return told(error);
  } catch (const std::exception& failure) {
    return told(system_failure(failure, "clevis"));
  }
}

/// What a run that was stopped did not finish.
void clean_up(const Options& options, const WatchedFiles& files) {
  report::remove_unfinished(output_folder(options));
  for (const fs::path& folder : files.mesh_folders()) {
    report::remove_unfinished(folder);
  }
}

}  // namespace

ExitCode watched_check(const Options& options,
                       const std::function<ExitCode(const Options&)>& check) {
  std::error_code ignored;
  if (!fs::is_regular_file(options.scene, ignored)) {
    throw Error("I001", options.scene.string(),
                fs::is_directory(options.scene, ignored)
                    ? "is a folder, not a file"
                : fs::exists(options.scene, ignored) ? "is not a regular file"
                                                     : "there is no such file",
                "Give the path of a scene (TOML).");
  }
  const StopSignals signals;
  const TemporaryFolder temporary;
  Options each = options;
  each.mesh = true;
  WatchedFiles files(options);
  ReportMark mark(options);
  for (;;) {
    files.look();
    each.watch_run = mark.begin_run();
    WatchProcess run(
        [&] {
          return run_once(each, check);
        },
        temporary.path());
    Outcome outcome = wait_for_end(run, files, options.scene, signals);
    mark.end_run();
    if (outcome != Outcome::kDone) clean_up(options, files);
    if (outcome == Outcome::kDone) {
      if (!run.ending().empty()) tell(run.ending());
      files.take_own_meshes();
      tell(fmt::format("watching {} files; Ctrl-C ends", files.size()));
      outcome = wait_for_change(files, options.scene, signals);
    }
    if (outcome == Outcome::kStopped) return kInterruptedExit;
  }
}

}  // namespace clevis::app
