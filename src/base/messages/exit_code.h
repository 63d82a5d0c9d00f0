#pragma once

namespace clevis {

/// Exit code of a process of clevis (README, "Exit codes").
enum class ExitCode {
  kPass = 0,
  kLimitExceeded = 1,
  kUsage = 2,
  kRegression = 3,
  kNotJudged = 4,
  kSceneInvalid = 10,
  kMeshInvalid = 11,
  kModelInvalid = 12,
  kSolverFailed = 20,
  kResourceLimit = 21,
  kIo = 22,
  kInternal = 70,
};

/// Interrupted: 128 + SIGINT, as shells expect it.
inline constexpr auto kInterruptedExit = static_cast<ExitCode>(130);

}  // namespace clevis
