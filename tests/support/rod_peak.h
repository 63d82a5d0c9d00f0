#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace clevis::support {

/// Largest stress at the held end of a rod that a rigid mass strikes at its
/// free end, over v √(E ρ): d'Alembert with a contact spring between. The wave
/// g that leaves the struck end under the force P fulfils P/Z = g(t) + g(t −
/// 2), Z = A √(E ρ).
/// @param striker  its mass over the rod's [1].
/// @param rise     Z/k over the wave's time through the rod [1].
/// @param until    looked at, over that time [1].
inline double rod_peak(double striker, double rise, double until = 3.1) {
  const double h = std::min(0.02 * rise, 1e-3);
  const auto steps = static_cast<std::size_t>((until - 1.0) / h);
  const auto delay = static_cast<std::size_t>(std::lround(2.0 / h));
  std::vector<double> g(steps, 0.0);
  double speed = 1.0, approach = 0.0, peak = 0.0;
  for (std::size_t i = 1; i < steps; ++i) {
    const double back = i >= delay ? g[i - delay] : 0.0;
    const double force = std::max(0.0, approach / rise);
    g[i] = force - back;
    speed -= h * force / striker;
    approach += h * (speed - (g[i] - back));
    peak = std::max(peak, 2.0 * g[i]);  // at the held end, 1 later
  }
  return peak;
}

}  // namespace clevis::support
