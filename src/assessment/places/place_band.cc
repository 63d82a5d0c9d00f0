#include "assessment/places/place_band.h"

#include <algorithm>

#include "assessment/places/meeting_places.h"

namespace clevis::assessment {

LargestPlace largest_place(std::span<const PlaceEstimate> places) {
  const auto largest =
      std::ranges::max_element(places, {}, &PlaceEstimate::value);
  double sum = 0.0, high = largest->high;
  int equals = 0;
  for (const PlaceEstimate& place : places) {
    high = std::max(high, place.high);
    if (place.high < largest->value) continue;
    sum += place.value;
    ++equals;
  }
  return {static_cast<std::size_t>(largest - places.begin()),
          largest->low - (largest->value - sum / equals), high};
}

double error_of_jump(double value, double jump) {
  constexpr double kAgreed = 0.5;
  return kErrorOfJump * std::max(0.0, jump - kAgreed * value);
}

}  // namespace clevis::assessment
