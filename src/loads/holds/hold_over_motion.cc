#include "loads/holds/hold_over_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "loads/holds/seat_hold.h"

namespace clevis::loads {

HoldOverMotion::HoldOverMotion(const mechanism::MechanismDefinition& definition,
                               mechanism::BodyIndex body,
                               std::vector<Seat> seats,
                               std::vector<Place> places)
    : definition_(definition),
      body_(body),
      seats_(std::move(seats)),
      places_(std::move(places)) {}

SeatHold HoldOverMotion::at(double time) {
  const auto next =
      std::ranges::min_element(places_, {}, [&](const Place& place) {
        return std::abs(place.instant.t - time);
      });
  const std::scoped_lock lock(mutex_);
  const auto [hold, is_new] = found_.try_emplace(next - places_.begin());
  if (is_new) {
    hold->second = seat_hold(definition_, next->instant, body_, seats_);
    hold->second.zones = next->zones;
  }
  return hold->second;
}

}  // namespace clevis::loads
