#pragma once

#include <cstddef>
#include <set>
#include <span>

namespace clevis::report {

/// Keeps more samples of a function until straight lines between those kept
/// meet all others.
///
/// The sample farthest off its line comes first, so that a blow among slow
/// changes is resolved before them. At two samples of one time a line holds the
/// value of the former.
/// @param kept  indices of samples, the first and the last among them; grows.
/// @param times  ascending, of the samples, in any unit.
/// @param values  of the samples, in any unit.
/// @param tolerance  of the distance to the line, in the unit of the values.
/// @param most  how many samples are kept at most.
void refine_lines(std::set<std::size_t>& kept, std::span<const double> times,
                  std::span<const double> values, double tolerance,
                  std::size_t most);

}  // namespace clevis::report
