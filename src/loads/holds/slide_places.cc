#include "loads/holds/slide_places.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "loads/history/motion_instants.h"
#include "loads/holds/holding_groups.h"

namespace clevis::loads {

std::vector<double> places_of_slide(const LoadHistory& history) {
  const auto& seats = history.seats;
  if (std::ranges::none_of(seats, [](const Seat& seat) {
        return !!seat.slide;
      })) {
    return {};
  }
  const auto holds = holding_groups(history);
  std::vector<double> found;
  double longest = -1.0;
  for (std::size_t s = 0; s < seats.size(); ++s) {
    if (!seats[s].slide || std::ranges::none_of(holds, [&](const auto& groups) {
          return std::ranges::find(groups, holder_of(seats, s)) != groups.end();
        })) {
      continue;
    }
    std::vector<double> places = places_on_wall(history, s);
    const auto [low, high] = ends_of(places);
    if (!(high - low > longest)) continue;
    longest = high - low;
    found = std::move(places);
  }
  return found;
}

SlidePlaces slide_places(const LoadHistory& history, int bins) {
  const std::vector<double> places = places_of_slide(history);
  if (places.empty()) return {};
  const auto [low, high] = ends_of(places);
  const double way = high - low;
  constexpr double kRests = 1e-9;  // [m]
  SlidePlaces found{.bins = way > kRests ? bins : 1,
                    .of = std::vector(places.size(), SlidePlaces::kUnknown)};
  for (std::size_t i = 0; i < places.size(); ++i) {
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
