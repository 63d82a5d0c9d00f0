#include "loads/holds/spread_seats.h"

#include <algorithm>
#include <cmath>

#include "loads/history/motion_instants.h"
#include "loads/holds/seat_hold.h"

namespace clevis::loads {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr Index kWrench = 6;

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

std::vector<std::size_t> spread_places(const std::vector<double>& places,
                                       int steps) {
  const auto ends = ends_of(places);
  const double low = ends.first, high = ends.second;
  std::vector<std::size_t> found;
  if (!(low <= high)) return found;
  for (int k = 0; k <= steps; ++k) {
    const double wanted = low + (high - low) * k / steps;
    const auto off = [&](double place) {
      return std::isfinite(place) ? std::abs(place - wanted) : HUGE_VAL;
    };
    const auto nearest = static_cast<std::size_t>(
        std::ranges::min_element(places, {}, off) - places.begin());
    if (found.empty() || places[nearest] > places[found.back()]) {
      found.push_back(nearest);
    }
  }
  return found;
}

std::vector<PlaceShare> shares_of(double place,
                                  const std::vector<double>& known) {
  const auto above = std::ranges::upper_bound(known, place);
  if (above == known.begin()) return {{0, 1.0}};
  const auto next = static_cast<std::size_t>(above - known.begin());
  if (above == known.end()) return {{next - 1, 1.0}};
  const double share =
      (place - known[next - 1]) / (known[next] - known[next - 1]);
  return {{next - 1, 1.0 - share}, {next, share}};
}

std::vector<PlaceShare> cubic_shares_of(double place,
                                        const std::vector<double>& known) {
  constexpr std::size_t kNodes = 4;
  const std::size_t count = std::min(kNodes, known.size());
  const auto above = static_cast<std::size_t>(
      std::ranges::upper_bound(known, place) - known.begin());
  const std::size_t first =
      std::min(known.size() - count, above > count / 2 ? above - count / 2 : 0);
  std::vector<PlaceShare> shares;
  for (std::size_t k = first; k < first + count; ++k) {
    double share = 1.0;
    for (std::size_t other = first; other < first + count; ++other) {
      if (other == k) continue;
      share *= (place - known[other]) / (known[k] - known[other]);
    }
    shares.emplace_back(k, share);
  }
  return shares;
}

SpreadSeats::SpreadSeats(const LoadHistory& history, int steps, double least) {
  const auto zone_at = [&](std::size_t instant, std::size_t seat) {
    const auto& zones = history.instants[instant].zones;
    return seat < zones.size() ? zones[seat] : ContactZone{};
  };
  for (std::size_t s = 0; s < history.seats.size(); ++s) {
    Way& way = places_.emplace_back();
    way.first = seats_.size();
    const auto add = [&](std::size_t instant) {
      seats_.push_back(history.seats[s]);
      zones_.push_back(zone_at(instant, s));
    };
    std::vector<double> places;
    if (history.seats[s].slide) places = places_on_wall(history, s);
    const auto [low, high] = ends_of(places);
    if (!(high - low > least)) {
      add(0);
      continue;
    }
    way.step = (high - low) / steps;
    constexpr double kApart = 0.5;  // of a step; nearer ones share badly
    for (const std::size_t i : spread_places(places, steps)) {
      if (!way.known.empty() &&
          places[i] - way.known.back() < kApart * way.step) {
        continue;
      }
      way.known.push_back(places[i]);
      instants_.push_back(i);
      add(i);
    }
    places.resize(history.instants.size(), NAN);
    fill(places);
    way.places = std::move(places);
  }
  const bool has_zones =
      std::ranges::any_of(history.instants, [](const InstantLoad& instant) {
        return !instant.zones.empty();
      });
  if (!has_zones) zones_.clear();
}

MatrixXd SpreadSeats::spread(const MatrixXd& wrenches,
                             std::size_t instant) const {
  if (wrenches.rows() == 0) return wrenches;
  MatrixXd all = MatrixXd::Zero(kWrench * std::ssize(seats_), wrenches.cols());
  for (std::size_t s = 0; s < places_.size(); ++s) {
    const Way& way = places_[s];
    const auto own =
        wrenches.middleRows<kWrench>(kWrench * static_cast<Index>(s));
    const auto shares = way.places.empty()
                            ? std::vector<PlaceShare>{{0, 1.0}}
                            : cubic_shares_of(way.places[instant], way.known);
    for (const auto& [place, share] : shares) {
      all.middleRows<kWrench>(kWrench * static_cast<Index>(way.first + place)) =
          share * own;
    }
  }
  return all;
}

SeatHold SpreadSeats::spread(SeatHold hold, std::size_t instant) const {
  if (!travels()) return hold;
  hold = with_wrenches(std::move(hold), [&](const MatrixXd& wrenches) {
    return spread(wrenches, instant);
  });
  hold.zones = zones_;
  return hold;
}

bool SpreadSeats::stand_alike(std::size_t one, std::size_t other) const {
  constexpr double kOfStep = 1.0 / 16.0;
  return std::ranges::all_of(places_, [&](const Way& way) {
    return way.places.empty() ||
           std::abs(way.places[one] - way.places[other]) <= kOfStep * way.step;
  });
}

}  // namespace clevis::loads
