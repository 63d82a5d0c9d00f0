#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <vector>

#include "loads/history/load_history.h"
#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"

namespace clevis::loads {

/// What holds a body at instants of its motion; worked out when it is asked for
/// first, once each.
class HoldOverMotion {
 public:
  struct Place {
    mechanism::Instant instant;
    std::vector<ContactZone> zones;  ///< as of the instant's load
  };

  /// @param seats  as of seat_hold(). @param places  at least one.
  HoldOverMotion(const mechanism::MechanismDefinition& definition,
                 mechanism::BodyIndex body, std::vector<Seat> seats,
                 std::vector<Place> places);

  /// At the place next to a time [s].
  SeatHold at(double time);

 private:
  mechanism::MechanismDefinition definition_;
  mechanism::BodyIndex body_;
  std::vector<Seat> seats_;
  std::vector<Place> places_;
  std::mutex mutex_;
  std::map<std::ptrdiff_t, SeatHold> found_;
};

}  // namespace clevis::loads
