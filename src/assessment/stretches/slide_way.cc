#include "assessment/stretches/slide_way.h"

#include <algorithm>
#include <cmath>

#include "loads/holds/slide_places.h"

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
  std::vector<double> places = loads::places_of_slide(motion);
  if (places.empty()) return {};
  places.resize(motion.instants.size(), NAN);
  fill(places);
  const auto [low, high] = std::ranges::minmax(places);
  return high - low > least ? places : std::vector<double>{};
}

}  // namespace clevis::assessment
