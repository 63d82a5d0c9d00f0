#include "beam/estimates/slide_positions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "loads/history/motion_instants.h"

namespace clevis::beam {
namespace {

using Eigen::Vector3d;

/// Of each seat by instant of the motion, from its point along the wall [m];
/// empty: it is no slide.
std::vector<std::vector<double>> places_of(const loads::LoadHistory& history) {
  std::vector<std::vector<double>> places;
  for (std::size_t s = 0; s < history.seats.size(); ++s) {
    places.push_back(history.seats[s].slide ? loads::places_on_wall(history, s)
                                            : std::vector<double>{});
  }
  return places;
}

/// Moves a seat; the wrenches stay the same on the whole part.
void move(loads::LoadHistory& history, std::size_t seat, const Vector3d& to) {
  const Vector3d arm = history.seats[seat].p_LS - to;
  history.seats[seat].p_LS = to;
  for (loads::InstantLoad& instant : history.instants) {
    loads::Wrench& wrench = instant.wrenches[seat];
    wrench.moment += arm.cross(wrench.force);
  }
}

}  // namespace

std::vector<loads::LoadHistory> at_slide_positions(
    const loads::LoadHistory& history) {
  constexpr int kPieces = 16;
  constexpr double kRests = 1e-9;  // [m]
  const auto places = places_of(history);
  if (std::ranges::all_of(places, [](const auto& of) {
        return of.empty();
      })) {
    return {history};
  }
  std::vector<double> low;
  double longest = kRests;
  for (const auto& of : places) {
    const auto ends = loads::ends_of(of);
    low.push_back(ends.first);
    longest = std::max(longest, ends.second - ends.first);
  }
  // Instants by the piece of its way in which each slide stands; those behind
  // the motion, and without a place, by themselves.
  std::map<std::vector<int>, std::vector<std::size_t>> pieces;
  for (std::size_t i = 0; i < history.instants.size(); ++i) {
    std::vector<int> piece;
    for (std::size_t s = 0; s < places.size(); ++s) {
      const auto& of = places[s];
      const bool is_known = i < of.size() && std::isfinite(of[i]);
      const double along = is_known ? of[i] - low[s] : -longest;
      piece.push_back(
          std::min(kPieces - 1, static_cast<int>(kPieces * along / longest)));
    }
    pieces[piece].push_back(i);
  }
  std::vector<loads::LoadHistory> found;
  for (const auto& [piece, instants] : pieces) {
    loads::LoadHistory& here = found.emplace_back(history);
    here.instants.clear();
    here.repeats.clear();
    for (const std::size_t i : instants) {
      here.instants.push_back(history.instants[i]);
    }
    for (std::size_t s = 0; s < places.size(); ++s) {
      if (places[s].empty() || piece[s] < 0) continue;
      double sum = 0.0;
      for (const std::size_t i : instants) sum += places[s][i];
      const loads::Seat& seat = history.seats[s];
      move(here, s,
           seat.p_LS + sum / static_cast<double>(instants.size()) *
                           seat.slide->along_L);
    }
  }
  return found;
}

}  // namespace clevis::beam
