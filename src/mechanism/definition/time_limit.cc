#include "mechanism/definition/time_limit.h"

#include <algorithm>
#include <cmath>

#include <time.h>

namespace clevis::mechanism {

double TimeLimit::processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) +
         1e-9 * static_cast<double>(now.tv_nsec);
}

TimeLimit::TimeLimit(double limit, double duration, int passes,
                     double (*clock)())
    : clock_(clock),
      limit_(limit),
      duration_(duration),
      start_(clock()),
      pass_start_(start_),
      passes_(passes),
      passes_left_(passes) {}

void TimeLimit::end_pass() {
  pass_start_ = clock_();
  --passes_left_;
  earlier_ = later_ = {};
}

bool TimeLimit::is_over(double t) {
  // A forecast goes by the later half of a pass, for a start may be slow. It is
  // believed after this time, and only if it is that far above the limit.
  constexpr double kLeast = 4.0;  // [s]
  constexpr double kFar = 100.0;
  const double now = clock_();
  const double used = now - start_, in_pass = now - pass_start_;
  if (in_pass > 2.0 * later_.used) {
    earlier_ = later_;
    later_ = {in_pass, t};
  }
  const double progress = std::max(t - earlier_.t, 1e-300);  // [s]
  const double rest = (duration_ - t) / progress * (in_pass - earlier_.used);
  forecast_ = used + rest + (passes_left_ - 1) * (in_pass + rest);
  return used > limit_ || (in_pass > kLeast && forecast_ > kFar * limit_);
}

double TimeLimit::share(double t) const {
  return (passes_ - passes_left_ + t / duration_) / passes_;
}

std::optional<double> TimeLimit::enough() const {
  constexpr double kPatience = 20.0;  // times the limit
  constexpr double kMargin = 3.0;     // of a machine that others slow down
  if (!(forecast_ < kPatience * limit_)) return std::nullopt;
  const double wanted = kMargin * std::max(forecast_, used());
  const double digit = std::pow(10.0, std::floor(std::log10(wanted)) - 1.0);
  return digit * std::ceil(wanted / digit);
}

}  // namespace clevis::mechanism
