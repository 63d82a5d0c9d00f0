#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace clevis::app {

/// A program to run and where.
struct Child {
  std::vector<std::string> arguments;  ///< the first is the program
  std::filesystem::path folder;        ///< its working folder, HOME and TMPDIR
  std::filesystem::path log;           ///< takes its stdout and stderr
  std::vector<std::string> environment = {};  ///< more "NAME=VALUE"
  std::optional<std::size_t> memory = {};     ///< most address space [byte]
  bool starts_others = false;  ///< may start other programs, as a script may
};

/// How it ended and what it used.
struct ChildOutcome {
  std::optional<int> status;  ///< as waitpid() has it; none: was killed
  double seconds{};           ///< wall clock, start and end included
  double cpu_seconds{};       ///< user and system
  double peak_memory{};       ///< largest resident set [byte]

  bool succeeded() const;
  bool was_found() const;  ///< false: the program could not be started
};

/// Runs a program to its end with an environment of PATH, HOME, TMPDIR,
/// LC_ALL=C and what is given, in a process group of its own; it dies with
/// clevis, is killed after `timeout` or at an interrupt that is deferred, may
/// write files up to 1 GiB, and, unless it is a script or `starts_others`,
/// starts no other program.
/// @throws Error I002 if no process can be started.
ChildOutcome run_child(const Child& child, std::chrono::milliseconds timeout);

}  // namespace clevis::app
