#include "base/system/interrupts.h"

#include <atomic>

#include <unistd.h>

#include "base/messages/exit_code.h"

namespace clevis {
namespace {

// Lock-free: a signal handler reads and writes them.
std::atomic<bool> interrupted = false;
std::atomic<int> deferring = 0;

[[noreturn]] void end_process() {
  _exit(static_cast<int>(kInterruptedExit));
}

void end_or_note(int) {
  interrupted = true;
  if (deferring == 0) end_process();
}

void set_handler(int signal, void (*handler)(int)) {
  struct sigaction action {
  }, before{};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  sigaction(signal, nullptr, &before);
  if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
}

}  // namespace

sigset_t interrupt_set() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : kInterrupts) sigaddset(&signals, signal);
  return signals;
}

void end_on_interrupts() {
  for (const int signal : kInterrupts) set_handler(signal, end_or_note);
}

void take_interrupts_as_they_come() {
  for (const int signal : kInterrupts) set_handler(signal, SIG_DFL);
}

void end_on_parents_signal() {
  std::signal(SIGINT, SIG_IGN);
  deferring = 0;
  interrupted = false;
  set_handler(SIGTERM, end_or_note);
}

bool is_interrupted() {
  return interrupted;
}

InterruptGuard::InterruptGuard() {
  ++deferring;
}

InterruptGuard::~InterruptGuard() {
  --deferring;
}

DeferredInterrupt::DeferredInterrupt() {
  ++deferring;
}

DeferredInterrupt::~DeferredInterrupt() {
  if (--deferring == 0 && interrupted) end_process();
}

}  // namespace clevis
