#pragma once

#include <chrono>

namespace clevis {

/// Wall-clock time between calls.
class Stopwatch {
 public:
  /// Time since the last call, or since construction [s].
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ =
      std::chrono::steady_clock::now();
};

}  // namespace clevis
