#include "loads/holds/slide_places.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "loads/history/motion_instants.h"
#include "loads/holds/holding_groups.h"

namespace clevis::loads {
namespace {

/// The first seat of a slide that holds the part.
std::optional<std::size_t> holding_slide(const LoadHistory& history) {
  const auto& seats = history.seats;
  if (std::ranges::none_of(seats, [](const Seat& seat) {
        return !!seat.slide;
      })) {
    return std::nullopt;
  }
  const auto holds = holding_groups(history);
  const auto found = std::ranges::find_if(seats, [&](const Seat& seat) {
    return seat.slide && std::ranges::any_of(holds, [&](const auto& groups) {
             return std::ranges::find(groups, seat.group) != groups.end();
           });
  });
  if (found == seats.end()) return std::nullopt;
  return static_cast<std::size_t>(found - seats.begin());
}

/// Twice the middle of a zone along its wall; of a zone that ends with the wall
/// one end is not known.
/// @param length  of the zone [m].
double place_of(const ContactZone& zone, double length) {
  const double from = zone.low[0], to = zone.high[0];
  if (std::isfinite(from)) {
    return std::isfinite(to) ? from + to : 2.0 * from + length;
  }
  return std::isfinite(to) ? 2.0 * to - length : HUGE_VAL;
}

}  // namespace

SlidePlaces slide_places(const LoadHistory& history, int bins, double least) {
  const std::size_t motion = motion_length(history);
  const auto slide = holding_slide(history);
  if (!slide || motion == 0) return {};
  const auto& instants = history.instants;
  double length = HUGE_VAL;  // the shortest that is known
  for (std::size_t i = 0; i < motion; ++i) {
    if (instants[i].zones.empty()) continue;
    const ContactZone& zone = instants[i].zones[*slide];
    length = std::min(length, zone.high[0] - zone.low[0]);
  }
  if (!std::isfinite(length)) length = 0.0;
  std::vector<double> places(motion, HUGE_VAL);
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (std::size_t i = 0; i < motion; ++i) {
    if (instants[i].zones.empty()) continue;
    places[i] = place_of(instants[i].zones[*slide], length);
    if (!std::isfinite(places[i])) continue;
    low = std::min(low, places[i]);
    high = std::max(high, places[i]);
  }
  if (!(low <= high)) return {};
  const double way = high - low;
  SlidePlaces found{.bins = way > 2.0 * least ? bins : 1,
                    .of = std::vector(motion, SlidePlaces::kUnknown)};
  for (std::size_t i = 0; i < motion; ++i) {
    if (!std::isfinite(places[i])) continue;
    found.of[i] =
        found.bins == 1
            ? 0
            : std::min(found.bins - 1,
                       static_cast<int>(found.bins * (places[i] - low) / way));
  }
  return found;
}

}  // namespace clevis::loads
