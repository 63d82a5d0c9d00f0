#include <algorithm>
#include <array>
#include <csignal>
#include <exception>
#include <iostream>
#include <memory>
#include <new>
#include <span>
#include <string_view>

#include <fcntl.h>
#include <unistd.h>

#include "app/command_line.h"
#include "app/command_list.h"
#include "app/request/error_output.h"
#include "base/system/huge_pages.h"
#include "base/system/interrupts.h"
#include "base/system/mpi_run.h"
#include "base/system/system_failure.h"

namespace {

using clevis::Error;

/// Runs the command and makes sure that its output has arrived.
clevis::ExitCode run(int argc, const char* const* argv) {
  const clevis::ExitCode code = clevis::app::run_command_line(argc, argv);
  if (!std::cout.flush()) {
    throw Error("I002", "stdout", "the output could not be written",
                "Check that the disk is not full.");
  }
  return code;
}

/// Under mpirun most commands are the first rank's work, and only that rank
/// speaks.
/// @return whether this rank has nothing to do.
bool stands_aside(const clevis::app::Command* command) {
  if (clevis::mpi_rank() == 0) return false;
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  close(nowhere);
  return command == nullptr || command->ranks != clevis::app::Ranks::kAll;
}

/// What no memory is left to say otherwise.
int fail_without_memory() {
  constexpr std::string_view kWords =
      "error[X002]: clevis: the memory ran out\n"
      "  help: Free memory, or raise the limits of this shell (ulimit -a) or "
      "container.\n";
  const auto written = write(STDERR_FILENO, kWords.data(), kWords.size());
  static_cast<void>(written);
  return static_cast<int>(clevis::ExitCode::kResourceLimit);
}

int fail(const Error& error, std::span<const char* const> arguments) {
  const bool wants_json =
      std::ranges::any_of(arguments, [](std::string_view text) {
        return text == "--json";
      });
  clevis::app::print_error(error, wants_json ? clevis::app::ErrorFormat::kJson
                                             : clevis::app::ErrorFormat::kText);
  return static_cast<int>(error.exit_code());
}

}  // namespace

int main(int argc, char** argv) {
  const std::span<const char* const> arguments(argv,
                                               static_cast<std::size_t>(argc));
  const clevis::app::Command* command =
      arguments.size() < 2 ? nullptr : clevis::app::find_command(arguments[1]);
  // What comes while the program starts anew waits for the handlers.
  const sigset_t interrupts = clevis::interrupt_set();
  sigprocmask(SIG_BLOCK, &interrupts, nullptr);
  if (command != nullptr && command->memory == clevis::app::Memory::kMuch) {
    clevis::restart_with_huge_pages(argv);
  }
  // Given back for the words that say that the memory ran out.
  auto reserve = std::make_unique<std::array<char, 1U << 16U>>();
  clevis::end_on_interrupts();
  sigprocmask(SIG_UNBLOCK, &interrupts, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);  // a write beyond the limit fails instead
  std::ios::sync_with_stdio(false);
  if (stands_aside(command)) return 0;
  try {
    try {
      return static_cast<int>(run(argc, argv));
    } catch (const Error& error) {
      return fail(error, arguments);
    } catch (const std::exception& failure) {
      reserve.reset();
      return fail(clevis::system_failure(failure, "clevis"), arguments);
    }
  } catch (const std::bad_alloc&) {
    return fail_without_memory();
  }
}
