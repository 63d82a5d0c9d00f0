#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <ostream>
#include <string>

namespace clevis::report {

/// Tells on stderr how far a command is: a bar that is redrawn on a
/// terminal, one line per 10 s elsewhere and nothing in the first 10 s there,
/// so that logs stay short.
///
/// May be called from several threads, and as often as the caller likes.
class Progress {
 public:
  enum class Stream { kTerminal, kLog };
  using Clock = std::function<std::chrono::steady_clock::time_point()>;

  /// @param out  outlives the object.
  Progress(std::ostream& out, Stream kind,
           Clock clock = std::chrono::steady_clock::now);
  /// On stderr, as it is.
  Progress();
  /// Leaves a clean line behind.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// @param done, total  steps, 0 <= done <= total.
  /// @param what  "solving DCE, BC"; one line.
  void update(int done, int total, const std::string& what);

  /// Removes the bar, so that other text can be written; a later update
  /// draws it again.
  void clear();

 private:
  using TimePoint = std::chrono::steady_clock::time_point;

  void draw_bar(int done, int total, const std::string& what);
  void write_line(int done, int total, const std::string& what);
  double seconds_since_start(TimePoint now) const;

  std::ostream& out_;
  Stream kind_;
  Clock clock_;
  TimePoint start_, last_output_;
  int last_done_ = -1;
  std::string last_what_;
  bool bar_is_drawn_ = false;
  std::mutex mutex_;
};

}  // namespace clevis::report
