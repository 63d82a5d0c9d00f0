#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>

namespace clevis::app {

/// A program of clevis' own that reads a file of a stranger, and how it is
/// asked.
struct Companion {
  const char* name;               ///< beside clevis or in lib/clevis
  const char* role;               ///< in messages: "mesher"
  const char* code;               ///< of its refusals
  const char* remedy;             ///< where it is too slow, too large or dies
  std::filesystem::path program;  ///< another one instead; empty: none
  std::chrono::milliseconds timeout;
  std::size_t memory;  ///< address space [byte]
};

/// Runs it as a child process: limits of time and memory, `folder` as its HOME
/// and working folder, hardly any environment, no program of its own; inside of
/// bubblewrap where that may be used (sandbox_command()).
/// @param file  that it reads, for messages.
/// @param question  path that it gets; it writes `folder`/answer.json.
/// @return its answer as it wrote it.
/// @throws Error of the companion's code if it comes to no answer.
std::string companion_answer(const Companion& companion,
                             const std::filesystem::path& file,
                             const std::filesystem::path& question,
                             const std::filesystem::path& folder);

/// What is said of an answer that cannot be read.
/// @throws Error of the companion's code, always.
[[noreturn]] void refuse_answer(const Companion& companion,
                                const std::filesystem::path& file,
                                const std::exception& failure);

}  // namespace clevis::app
