#pragma once

#include <array>
#include <csignal>

namespace clevis {

/// The signals by which a user, a terminal or a system ends a program.
inline constexpr std::array kInterrupts = {SIGINT, SIGTERM, SIGHUP};

/// The same as a set.
sigset_t interrupt_set();

/// Makes each of kInterrupts end this process with exit code 130, at
/// once or when the last DeferredInterrupt has ended. One that the process
/// ignores already (nohup) stays so. What is noted and deferred belongs to the
/// executable or the library that links this: a library that was loaded calls
/// it again.
void end_on_interrupts();

/// Undoes end_on_interrupts() in a process that was forked: they end it at
/// once, by the signal. One that the process ignores stays so.
void take_interrupts_as_they_come();

/// For a process that was forked: forgets what its parent noted and deferred,
/// and leaves the terminal's Ctrl-C to the parent.
void end_on_parents_signal();

/// Whether a signal came that is deferred.
bool is_interrupted();

/// Notes interrupts while it lives. What to do then is up to who made it, who
/// can still tell what is finished.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
};

/// Defers interrupts while something would be left half done; the process ends
/// with it if one came and no other defers.
class DeferredInterrupt {
 public:
  DeferredInterrupt();
  ~DeferredInterrupt();
  DeferredInterrupt(const DeferredInterrupt&) = delete;
  DeferredInterrupt& operator=(const DeferredInterrupt&) = delete;
};

}  // namespace clevis
