#include "base/system/interrupts.h"

#include <csignal>
#include <functional>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace clevis {
namespace {

constexpr int kReachedTheEnd = 7;
constexpr int kInterrupted = 130;

/// Exit code of a process that runs this, or -1 if a signal ended it.
int exit_code_of(const std::function<void()>& run) {
  const pid_t child = fork();
  if (child == 0) {
    run();
    _exit(kReachedTheEnd);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(Interrupts, EndTheProcess) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    EXPECT_EQ(exit_code_of([&] {
                end_on_interrupts();
                raise(signal);
              }),
              kInterrupted);
  }
}

TEST(Interrupts, LeaveWhatNohupIgnores) {
  EXPECT_EQ(exit_code_of([] {
              std::signal(SIGHUP, SIG_IGN);
              end_on_interrupts();
              raise(SIGHUP);
            }),
            kReachedTheEnd);
}

TEST(Interrupts, EndByTheSignalWhereTheyAreTakenAsTheyCome) {
  constexpr int kBySignal = -1;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const auto run = [&] {
      end_on_interrupts();
      const InterruptGuard guard;  // the parent's
      take_interrupts_as_they_come();
      raise(signal);
    };
    EXPECT_EQ(exit_code_of(run), kBySignal) << signal;
    const auto ignored = [&] {
      std::signal(signal, SIG_IGN);
      run();
    };
    EXPECT_EQ(exit_code_of(ignored), kReachedTheEnd) << signal;
  }
}

TEST(Interrupts, AreOneSet) {
  const sigset_t signals = interrupt_set();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    EXPECT_EQ(sigismember(&signals, signal), 1) << signal;
  }
  EXPECT_EQ(sigismember(&signals, SIGUSR1), 0);
}

TEST(Interrupts, WaitForTheLastThatDefers) {
  EXPECT_EQ(exit_code_of([] {
              end_on_interrupts();
              DeferredInterrupt outer;
              {
                const DeferredInterrupt inner;
                raise(SIGTERM);
                if (!is_interrupted()) _exit(1);
              }
              _exit(kReachedTheEnd);  // inner must not end it
            }),
            kReachedTheEnd);
  EXPECT_EQ(exit_code_of([] {
              end_on_interrupts();
              {
                const DeferredInterrupt deferred;
                raise(SIGTERM);
              }
            }),
            kInterrupted);
}

TEST(Interrupts, AreTheGuardsToTell) {
  EXPECT_EQ(exit_code_of([] {
              end_on_interrupts();
              const InterruptGuard guard;
              {
                const DeferredInterrupt deferred;
                raise(SIGINT);
              }
              if (!is_interrupted()) _exit(1);
            }),
            kReachedTheEnd);
}

TEST(Interrupts, AreForgottenByAForkedWorker) {
  EXPECT_EQ(exit_code_of([] {
              end_on_interrupts();
              const InterruptGuard guard;
              raise(SIGINT);
              end_on_parents_signal();
              if (is_interrupted()) _exit(1);
              raise(SIGINT);  // the terminal's, which the parent sees too
              if (is_interrupted()) _exit(2);
              raise(SIGTERM);
            }),
            kInterrupted);
}

}  // namespace
}  // namespace clevis
