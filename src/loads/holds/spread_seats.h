#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "loads/history/load_history.h"

namespace clevis::loads {

/// Instants whose places are spread evenly over a way, by rising place.
/// @param places  by instant [m]; nothing known: NaN. @param steps  in all.
std::vector<std::size_t> spread_places(const std::vector<double>& places,
                                       int steps);

/// A place, and its share [1].
using PlaceShare = std::pair<std::size_t, double>;

/// Of a place between some that rise [m].
std::vector<PlaceShare> shares_of(double place,
                                  const std::vector<double>& known);

/// The same by the cubic through four of them, the nearest [m].
std::vector<PlaceShare> cubic_shares_of(double place,
                                        const std::vector<double>& known);

/// A part's seats, of which each slide that travels, be it that it holds the
/// part or weighs on it, is taken apart into seats of their own at places of
/// its way: what it takes in between is shared by the four next to it.
class SpreadSeats {
 public:
  /// @param steps  of a way. @param least  way that counts as one [m].
  SpreadSeats(const LoadHistory& history, int steps, double least);

  bool travels() const { return seats_.size() > places_.size(); }
  const std::vector<Seat>& seats() const { return seats_; }
  /// At which slides stand at the places.
  const std::vector<std::size_t>& instants() const { return instants_; }
  /// What is touched of each; empty: all of each group.
  const std::vector<ContactZone>& zones() const { return zones_; }
  /// Wrenches on the history's seats at an instant, 6 n × columns, as wrenches
  /// on these [N], [N m].
  Eigen::MatrixXd spread(const Eigen::MatrixXd& wrenches,
                         std::size_t instant) const;
  SeatHold spread(SeatHold hold, std::size_t instant) const;
  /// Whether no slide is farther away at another instant than a sixteenth of a
  /// step.
  bool stand_alike(std::size_t one, std::size_t other) const;

 private:
  struct Way {
    std::size_t first{};         ///< of seats()
    std::vector<double> known;   ///< places of these, rising [m]
    std::vector<double> places;  ///< by instant [m]; empty: one place
    double step{};               ///< [m]
  };
  std::vector<Way> places_;  ///< by the history's seats
  std::vector<std::size_t> instants_;
  std::vector<Seat> seats_;
  std::vector<ContactZone> zones_;
};

}  // namespace clevis::loads
