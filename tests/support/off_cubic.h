#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "mechanism/definition/motion.h"

namespace clevis::mechanism::testing {

/// Largest distance of a load from the cubics through four each of the instants
/// and repeats of a motion, halfway between two, up to a time.
/// @param of     the load at an instant. @param exact  the same at a time.
inline double off_cubic(const Motion& motion, double until,
                        const std::function<double(const Instant&)>& of,
                        const std::function<double(double)>& exact) {
  std::vector<const Instant*> all;
  for (const auto* list : {&motion.instants, &motion.repeats}) {
    for (const Instant& at : *list) all.push_back(&at);
  }
  std::ranges::sort(all, {}, &Instant::t);
  double worst = 0.0;
  for (std::size_t i = 1; i + 2 < all.size() && all[i + 2]->t <= until; ++i) {
    const double t = 0.5 * (all[i]->t + all[i + 1]->t);
    double value = 0.0;
    for (std::size_t j = i - 1; j < i + 3; ++j) {
      double weight = 1.0;
      for (std::size_t k = i - 1; k < i + 3; ++k) {
        if (k != j) weight *= (t - all[k]->t) / (all[j]->t - all[k]->t);
      }
      value += weight * of(*all[j]);
    }
    worst = std::max(worst, std::abs(value - exact(t)));
  }
  return worst;
}

}  // namespace clevis::mechanism::testing
