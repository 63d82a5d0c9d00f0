#include "loads/history/motion_instants.h"

#include <algorithm>
#include <cmath>

namespace clevis::loads {
namespace {

/// Of a zone that ends with the wall one end is not known. @param length [m].
double middle_of(const ContactZone& zone, double length) {
  const double from = zone.low[0], to = zone.high[0];
  if (std::isfinite(from)) {
    return std::isfinite(to) ? 0.5 * (from + to) : from + 0.5 * length;
  }
  return std::isfinite(to) ? to - 0.5 * length : NAN;
}

double longest_step_of(const LoadHistory& history, std::size_t seat) {
  const std::vector<double> at = places_on_wall(history, seat);
  const double sides = kEventSides * motion_duration(history);
  double low = HUGE_VAL, high = -HUGE_VAL, longest = 0.0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (!std::isfinite(at[i])) return 0.0;
    low = std::min(low, at[i]);
    high = std::max(high, at[i]);
    if (i == 0 ||
        history.instants[i].time - history.instants[i - 1].time <= sides) {
      continue;
    }
    longest = std::max(longest, std::abs(at[i] - at[i - 1]));
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
  const auto goes_on = [](const InstantLoad& before, const InstantLoad& next) {
    return next.time >= before.time && !next.is_case;
  };
  while (motion < instants.size() &&
         goes_on(instants[motion - 1], instants[motion])) {
    ++motion;
  }
  return motion;
}

double motion_duration(const LoadHistory& history) {
  if (history.instants.empty()) return 0.0;
  return history.instants[motion_length(history) - 1].time -
         history.instants.front().time;
}

std::vector<double> places_on_wall(const LoadHistory& history,
                                   std::size_t seat) {
  const std::size_t n = motion_length(history);
  const auto zone = [&](std::size_t i) {
    const auto& zones = history.instants[i].zones;
    return seat < zones.size() ? &zones[seat] : nullptr;
  };
  double length = HUGE_VAL;  // the shortest that is known
  for (std::size_t i = 0; i < n; ++i) {
    if (zone(i)) length = std::min(length, zone(i)->high[0] - zone(i)->low[0]);
  }
  if (!std::isfinite(length)) length = 0.0;
  std::vector<double> places(n, NAN);
  for (std::size_t i = 0; i < n; ++i) {
    if (zone(i)) places[i] = middle_of(*zone(i), length);
  }
  return places;
}

std::pair<double, double> ends_of(const std::vector<double>& places) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const double place : places) {
    if (!std::isfinite(place)) continue;
    low = std::min(low, place);
    high = std::max(high, place);
  }
  return {low, high};
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
