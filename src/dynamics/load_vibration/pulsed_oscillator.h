#pragma once

#include <Eigen/Core>

#include "dynamics/load_vibration/load_path.h"

namespace clevis::dynamics {

/// Stiffness of a mode that loads along a part change.
struct PulsedMode {
  double period{};   ///< without them [s]
  double damping{};  ///< ratio [1]
  double share{};    ///< of the stiffness that their largest change takes [1]
};

/// By how much a disturbance of x'' + 2 ζ ω x' + ω² (1 − share c(t)) x = 0
/// grows over a path c at most, be it of the place or of the speed (parametric
/// resonance where c pulses near twice the frequency) [1].
/// @param coordinate  of the path, whose largest value is 1.
double pulsed_growth(const LoadPath& path, Eigen::Index coordinate,
                     const PulsedMode& mode);

}  // namespace clevis::dynamics
