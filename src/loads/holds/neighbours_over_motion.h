#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "loads/history/load_history.h"
#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"
#include "mechanism/neighbours/load_gains.h"
#include "mechanism/neighbours/neighbours.h"

namespace clevis::loads {

/// What the rest of the mechanism holds of a body, and what its loads gain as
/// seats give way, at instants of its motion; worked out when it is asked for
/// first, once each. Contacts and stops hold a part while they press and do not
/// bounce, friction while it sticks.
class NeighboursOverMotion {
 public:
  struct Place {
    mechanism::Instant instant;
    std::vector<ContactZone> zones;  ///< as of the instant's load
  };

  /// @param seats  of the part's history. @param acting  what acts on each.
  /// @param places  of all instants, at least one. @param wanted  load factor
  /// that the body must bear, of which gains are asked [1].
  NeighboursOverMotion(const mechanism::MechanismDefinition& definition,
                       mechanism::BodyIndex body, std::vector<Seat> seats,
                       std::vector<mechanism::LoadPlace> acting,
                       std::vector<Place> places, double wanted);
  ~NeighboursOverMotion();

  /// At the place next to a time [s].
  SeatHold hold(double time);
  /// The same without contacts and stops that let go at other instants.
  /// @param time  [s].
  SeatHold lasting_hold(double time);
  /// That of a mechanism at rest, whose friction breaks away as it gives way by
  /// 1/200 [rad] and whose gas flows; absent: nothing yields otherwise.
  std::optional<SeatHold> hold_at_rest(double time) const;
  /// At an instant, about the seats' points, by what holds always. Of a slide
  /// only the displacement of its joint's point counts as turning nothing.
  SeatGains gains(std::size_t instant);

 private:
  using Elements = std::vector<std::size_t>;
  /// What holds the body, with some force elements left out.
  class Holder;

  std::size_t place_next_to(double time) const;
  SeatHold hold_by(const mechanism::Neighbours& neighbours,
                   const Place& place) const;
  SeatGains found_gains(const mechanism::Neighbours& neighbours,
                        const Place& place) const;
  bool presses_meanwhile(const mechanism::Instant& instant) const;
  Holder& holder(const Elements& left_out);
  SeatHold hold_at(std::size_t place, const Elements& left_out);

  mechanism::MechanismDefinition definition_;
  mechanism::BodyIndex body_;
  std::vector<Seat> seats_;
  Elements letting_go_;  ///< press, but not always
  std::vector<mechanism::LoadPlace> acting_;
  std::vector<Place> places_;
  std::vector<Elements> bouncing_;  ///< at each place
  double wanted_;
  std::mutex mutex_;
  std::map<Elements, std::unique_ptr<Holder>> holders_;  ///< by those left out
  std::map<std::size_t, SeatGains> gains_;
};

}  // namespace clevis::loads
