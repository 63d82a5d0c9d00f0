#pragma once

#include <Eigen/Core>

#include "dynamics/load_vibration/damped_modes.h"
#include "dynamics/load_vibration/load_path.h"

namespace clevis::dynamics {

/// A body's vibration about its quasi-static answer.
struct LoadAnswer {
  Eigen::VectorXd time;    ///< the path's instants and the others, rising [s]
  Eigen::MatrixXd path;    ///< coordinates of the quasi-static answer × times
  Eigen::MatrixXd added;   ///< of each mode, what vibration adds, × times
  Eigen::VectorXd energy;  ///< Σ ½ (w'² + ω² w²): of the vibration [J]
};

/// Vibration of modes about the quasi-static answer u = U c(t).
///
/// M u'' + K u = f with K U c = f has u = U c + Φ w, and for M-orthonormal
/// modes without rigid motion
///     w'' + (2 ζ ω + C) w' + ω² w = −x'' − 2 ζ ω x',   x = Φᵀ M U c,
/// C of dampers that it stands on.
/// x is cubic between the instants, so each interval is solved exactly; where
/// x jumps, w jumps the other way, for a body cannot. Changes sharper than τ,
/// |x''| τ² > max |x|/10 and jumps, are spread by a bell curve of that standard
/// deviation: exp(−(ω τ)²/2) of them is left. Of gentler ones all is left to ω
/// τ = 3 and nothing from 6: modes above follow at rest. Before the first
/// instant the load stands still.
///
/// @param participation  Φᵀ M U, modes × coordinates of the path.
/// @param squares        ω² > 0 [1/s²].
/// @param others         times to be looked at besides, rising, within the
///   path [s].
/// @param front           τ, >= 0: few modes overshoot behind a sharper wave
///   front than they can carry, however many they are [s].
LoadAnswer answer_to(const LoadPath& path, const Eigen::MatrixXd& participation,
                     const Eigen::VectorXd& squares, const ModeDamping& damping,
                     const Eigen::VectorXd& others, double front = 0.0);

/// What the spread by `front` takes off the loads' largest values, over the
/// largest of all modes by ω x [1]: of pulses that are as short. 0 where it
/// leaves them alone, as steps.
double cut_by_spread(const LoadPath& path, const Eigen::MatrixXd& participation,
                     const Eigen::VectorXd& squares, double front);

}  // namespace clevis::dynamics
