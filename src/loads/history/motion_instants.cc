#include "loads/history/motion_instants.h"

#include <algorithm>
#include <cmath>

namespace clevis::loads {
namespace {

/// Along the slide, about the seat's p_LS; NaN where the zone has no edge [m].
double middle_of(const InstantLoad& instant, std::size_t seat) {
  if (seat >= instant.zones.size()) return NAN;
  const ContactZone& zone = instant.zones[seat];
  return 0.5 * (zone.low[0] + zone.high[0]);
}

double longest_step_of(const LoadHistory& history, std::size_t seat) {
  const std::size_t n = motion_length(history);
  const double sides = kEventSides * motion_duration(history);
  double low = HUGE_VAL, high = -HUGE_VAL, longest = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double at = middle_of(history.instants[i], seat);
    if (!std::isfinite(at)) return 0.0;
    low = std::min(low, at);
    high = std::max(high, at);
    if (i == 0 ||
        history.instants[i].time - history.instants[i - 1].time <= sides) {
      continue;
    }
    longest = std::max(longest,
                       std::abs(at - middle_of(history.instants[i - 1], seat)));
  }
  constexpr double kRest = 1e-9;  // of where it stands: round-off, no way
  const double way = high - low;
  return way > kRest * std::max(std::abs(low), std::abs(high)) ? longest / way
                                                               : 0.0;
}

}  // namespace

std::size_t motion_length(const LoadHistory& history) {
  const auto& instants = history.instants;
  std::size_t motion = std::min<std::size_t>(1, instants.size());
  const auto goes_on = [&](double before, double time) {
    return time > before || (time == before && time != 0.0);  // a step
  };
  while (motion < instants.size() &&
         goes_on(instants[motion - 1].time, instants[motion].time)) {
    ++motion;
  }
  return motion;
}

double motion_duration(const LoadHistory& history) {
  if (history.instants.empty()) return 0.0;
  return history.instants[motion_length(history) - 1].time -
         history.instants.front().time;
}

double longest_slide_step(const LoadHistory& history) {
  double longest = 0.0;
  for (std::size_t s = 0; s < history.seats.size(); ++s) {
    if (!history.seats[s].slide) continue;
    longest = std::max(longest, longest_step_of(history, s));
  }
  return longest;
}

}  // namespace clevis::loads
