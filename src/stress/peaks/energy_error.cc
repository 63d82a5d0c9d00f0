#include "stress/peaks/energy_error.h"

#include <cassert>
#include <cmath>

namespace clevis::stress {

double strain_energy_error(std::span<const EnergyValue> sequence) {
  assert(sequence.size() >= 3);
  const auto last = sequence.last(3);
  const double energy = last[2].energy;
  if (energy == 0.0) return 0.0;
  const double near = energy - last[1].energy;
  const double far = energy - last[0].energy;
  const double unsettled = std::abs(near / energy);
  if (!(near > 0.0 && far > near)) return unsettled;
  const double ratio =
      std::log(static_cast<double>(last[2].dofs) / last[1].dofs) /
      std::log(static_cast<double>(last[1].dofs) / last[0].dofs);
  // Of what is missing, x: slopes of both pairs alike.
  const auto bend = [&](double x) {
    return std::log(x / (x + near)) - ratio * std::log((x + near) / (x + far));
  };
  double low = std::log(1e-12 * near);
  double high = std::log(1e6 * near);
  if (bend(std::exp(low)) > 0.0 || bend(std::exp(high)) < 0.0) {
    return unsettled;
  }
  constexpr int kHalvings = 60;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (low + high);
    (bend(std::exp(middle)) < 0.0 ? low : high) = middle;
  }
  return std::exp(high) / energy;
}

}  // namespace clevis::stress
