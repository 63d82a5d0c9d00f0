#pragma once

#include <vector>

#include "loads/history/load_history.h"

namespace clevis::loads {

/// Middles of what is touched of the wall of a slide that holds a part, by
/// instant of the motion [m], as of places_on_wall(); of the slide that goes
/// the longest way. Empty: none is known.
std::vector<double> places_of_slide(const LoadHistory& history);

/// The places that a slide which holds a part takes on its wall in a motion, in
/// bins of equal width.
struct SlidePlaces {
  static constexpr int kUnknown = -1;

  int bins{};           ///< 0: no slide holds the part, or no place is known
  std::vector<int> of;  ///< bin by instant of the motion, or kUnknown
};

/// Of the one that goes the longest way. @param bins  so many, where it
/// travels.
SlidePlaces slide_places(const LoadHistory& history, int bins);

}  // namespace clevis::loads
