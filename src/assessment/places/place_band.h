#pragma once

#include <cstddef>
#include <span>

namespace clevis::assessment {

/// Largest stress of a place by finer solutions, with its band [Pa].
struct PlaceEstimate {
  double value{}, low{}, high{};
};

/// The place with the largest value, and the band of the largest of all [Pa].
struct LargestPlace {
  std::size_t place{};
  double low{}, high{};
};

/// The largest of several places that may be equal was chosen by its error too:
/// the band reaches lower by its distance to their mean. It ends with the
/// highest band of all.
/// @param places  at least one.
LargestPlace largest_place(std::span<const PlaceEstimate> places);

}  // namespace clevis::assessment
