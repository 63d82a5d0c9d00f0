#pragma once

#include <vector>

#include <Eigen/Core>

#include "dynamics/load_vibration/forced_interval.h"

namespace clevis::dynamics {

/// Damping of modes.
struct ModeDamping {
  /// ζ of each by the body itself, 0 <= ζ < 1 [1].
  Eigen::ArrayXd own;
  /// Φᵀ D Dᵀ Φ of dampers that the body stands on, modes × modes [1/s]; empty:
  /// none. They do not feel the quasi-static answer.
  Eigen::MatrixXd dampers = {};

  /// @param damping  ζ of all modes [1].
  static ModeDamping even(double damping, Eigen::Index modes) {
    return {Eigen::ArrayXd::Constant(modes, damping)};
  }
};

/// Modes that dampers couple: those whose ratio by them counts. The others are
/// the body's own.
///
///     w'' + (2 ζ ω + C) w' + ω² w = −x'' − 2 ζ ω x'
///
/// by the complex eigenvectors of ω w and w'.
class DampedModes {
 public:
  DampedModes(const Eigen::ArrayXd& omega, const ModeDamping& damping);

  /// An interval on which x is cubic.
  class Interval {
   public:
    /// @param modes, x, start  as of ForcedInterval, of all modes; outlive the
    ///   object.
    Interval(const DampedModes& modes, const Eigen::ArrayX3d& x,
             const SwingState& start);
    /// Puts the coupled modes. @param t  since the interval's start [s].
    void put(double t, SwingState& state) const;

   private:
    const DampedModes& modes_;
    Eigen::VectorXcd free_, constant_, linear_, square_;
  };

 private:
  std::vector<Eigen::Index> coupled_;
  Eigen::ArrayXd omega_, drag_;  ///< of the coupled ones: ω, 2 ζ ω
  Eigen::VectorXcd rates_;       ///< eigenvalues [1/s]
  Eigen::MatrixXcd vectors_, inverse_;
};

}  // namespace clevis::dynamics
