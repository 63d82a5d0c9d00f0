#pragma once

#include <vector>

#include <Eigen/Core>

#include "dynamics/load_vibration/load_path.h"

namespace clevis::dynamics {

/// Answer of oscillators of several periods to each coordinate of a load
/// history by itself: its shock response spectrum, whatever the load's shape (a
/// jump, a ramp, stairs, a pulse, a sine).
struct ResponseSpectrum {
  /// Largest answer over the coordinate's largest magnitude [1].
  double amplification = 1.0;
  double time{};    ///< of it [s]
  double period{};  ///< of its oscillator [s]
  /// Where the load makes an oscillator swing that answers beyond `least`:
  /// begins of the intervals in which its swing grows by a tenth and is no less
  /// than 0.3 of its largest; rising [s].
  std::vector<double> onsets;
};

/// @param path     before its first instant the load stands still.
/// @param periods  [s]. @param damping  ζ < 1 [1].
/// @param least    amplification that counts, > 1 [1].
ResponseSpectrum response_spectrum(const LoadPath& path,
                                   const Eigen::VectorXd& periods,
                                   double damping, double least);

/// Largest answer, likewise, of an oscillator whose frequency changes meanwhile
/// [1].
/// @param periods  by instant of the path [s].
double swept_amplification(const LoadPath& path, const Eigen::VectorXd& periods,
                           double damping);

}  // namespace clevis::dynamics
