#include "assessment/vibration/slide_way.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "loads/history/motion_instants.h"
#include "loads/holds/holding_groups.h"

namespace clevis::assessment {
namespace {

/// Puts what is known before, or else first, in the place of what is not.
/// @pre  some are known.
void fill(std::vector<double>& places) {
  const auto is_known = [](double place) {
    return std::isfinite(place);
  };
  double last = *std::ranges::find_if(places, is_known);
  for (double& place : places) {
    if (is_known(place)) {
      last = place;
    } else {
      place = last;
    }
  }
}

}  // namespace

std::vector<double> slide_way(const loads::LoadHistory& motion, double least) {
  const auto& seats = motion.seats;
  if (std::ranges::none_of(seats, [](const loads::Seat& seat) {
        return seat.slide.has_value();
      })) {
    return {};
  }
  const auto holds = loads::holding_groups(motion);
  std::vector<double> found;
  double longest = least;
  for (std::size_t s = 0; s < seats.size(); ++s) {
    const bool slides_and_holds =
        seats[s].slide && std::ranges::any_of(holds, [&](const auto& groups) {
          return std::ranges::find(groups, seats[s].group) != groups.end();
        });
    if (!slides_and_holds) continue;
    std::vector<double> places = loads::places_on_wall(motion, s);
    if (std::ranges::none_of(places, [](double place) {
          return std::isfinite(place);
        })) {
      continue;
    }
    places.resize(motion.instants.size(), NAN);
    fill(places);
    const auto [low, high] = std::ranges::minmax(places);
    if (!(high - low > longest)) continue;
    longest = high - low;
    found = std::move(places);
  }
  return found;
}

}  // namespace clevis::assessment
