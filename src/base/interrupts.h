#pragma once

namespace clevis {

/// Makes SIGINT, SIGTERM and SIGHUP end this process with exit code 130, at
/// once or when the last DeferredInterrupt has ended. One that the process
/// ignores already (nohup) stays so. What is noted and deferred belongs to the
/// executable or the library that links this: a library that was loaded calls
/// it again.
void end_on_interrupts();

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
