#include "report/text/progress.h"

#include <algorithm>
#include <iostream>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#include "report/text/terminal.h"

namespace clevis::report {
namespace {

using std::chrono::duration;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr auto kLogInterval = seconds(10);
// The eye follows ten redraws a second; more only cost time.
constexpr auto kRedrawInterval = milliseconds(100);
constexpr int kBarWidth = 10;
// A wrapped line would not be wiped by the next redraw.
constexpr std::size_t kLongestLine = 79;

constexpr const char* kWipeLine = "\r\033[K";

/// The start of a UTF-8 text, cut between characters.
std::string shortened(const std::string& text, std::size_t longest) {
  std::size_t end = std::min(text.size(), longest);
  while (end > 0 && end < text.size() &&
         (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) {
    --end;
  }
  return text.substr(0, end);
}

}  // namespace

Progress::Progress(std::ostream& out, Stream kind, Clock clock)
    : out_(out), kind_(kind), clock_(std::move(clock)), start_(clock_()) {
  last_output_ = start_;
}

Progress::Progress()
    : Progress(std::cerr,
               isatty(STDERR_FILENO) != 0 ? Stream::kTerminal : Stream::kLog) {}

Progress::~Progress() {
  clear();
}

void Progress::update(int done, int total, const std::string& what) {
  const std::lock_guard lock(mutex_);
  const std::string text = printable(what);
  if (kind_ == Stream::kTerminal) {
    draw_bar(done, total, text);
  } else {
    write_line(done, total, text);
  }
}

void Progress::clear() {
  const std::lock_guard lock(mutex_);
  if (bar_is_drawn_) out_ << kWipeLine << std::flush;
  bar_is_drawn_ = false;
}

void Progress::draw_bar(int done, int total, const std::string& what) {
  const TimePoint now = clock_();
  const bool changed = done != last_done_ || what != last_what_;
  const bool due = now - last_output_ >= kRedrawInterval;
  if (bar_is_drawn_ && !changed && !due) return;
  last_output_ = now;
  last_done_ = done;
  last_what_ = what;
  const int filled = total > 0 ? kBarWidth * done / total : 0;
  const std::string bar =
      fmt::format("[{:<{}}] {}/{} {:5.1f} s  ",
                  std::string(static_cast<std::size_t>(filled), '#'), kBarWidth,
                  done, total, seconds_since_start(now));
  out_ << kWipeLine << bar
       << shortened(what, kLongestLine - std::min(kLongestLine, bar.size()))
       << std::flush;
  bar_is_drawn_ = true;
}

void Progress::write_line(int done, int total, const std::string& what) {
  const TimePoint now = clock_();
  if (now - last_output_ < kLogInterval) return;
  last_output_ = now;
  out_ << fmt::format("{:.0f} s: {}/{} {}\n", seconds_since_start(now), done,
                      total, what)
       << std::flush;
}

double Progress::seconds_since_start(TimePoint now) const {
  return duration<double>(now - start_).count();
}

}  // namespace clevis::report
