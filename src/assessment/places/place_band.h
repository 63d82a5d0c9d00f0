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

/// What a jump of stress between the cells that meet at a place leaves open in
/// its finer solutions, which have their borders from those cells [Pa]: nothing
/// where they agree on half of the stress.
/// @param value  by finer solutions [Pa]. @param jump  as solved [Pa].
double error_of_jump(double value, double jump);

}  // namespace clevis::assessment
