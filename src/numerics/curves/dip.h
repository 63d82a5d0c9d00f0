#pragma once

#include <algorithm>
#include <cmath>

namespace clevis::numerics {

/// Whether a function of these values at the ends of an interval, with a second
/// derivative of at most `bend` over the square of its length, may be below
/// −floor in between: no lower than the parabola through both that bends so.
/// All in the units of the function.
inline bool may_dip(double left, double right, double bend, double floor) {
  const double rise = std::abs(right - left);
  if (right < 0.0 || !(rise < 0.5 * bend)) return false;
  const double dip = (0.5 * bend - rise) * (0.5 * bend - rise) / (2.0 * bend);
  return std::max(std::min(left, right), 0.0) + floor < dip;
}

}  // namespace clevis::numerics
