#pragma once

#include <Eigen/Core>

namespace clevis::mechanism {

/// Angles of b against a about z of a, the turned x, and y of b:
/// R_ab = Rz(q1) Rx(q2) Ry(q3), |q2| < 90°.
///
/// ω_ab = Σ q̇_k e_k, hence q̇_k = g_k · ω_ab with g the reciprocal axes.
/// Left out: |q2| = 90°, where e_1 = ±e_3 and the rates have no bound.
struct CardanAngles {
  /// @param axes_a, axes_b  columns: unit vectors of the axes, in one frame.
  CardanAngles(const Eigen::Matrix3d& axes_a, const Eigen::Matrix3d& axes_b);

  /// Bias of q̈_k = g_k · (α_b − α_a) + bias [rad/s²]; w_a, w_b the angular
  /// velocities [rad/s].
  double bias(int k, const Eigen::Vector3d& w_a,
              const Eigen::Vector3d& w_b) const;

  Eigen::Vector3d angles;     ///< [rad]
  Eigen::Matrix3d axes;       ///< columns e_k
  Eigen::Matrix3d rate_axes;  ///< columns g_k
};

}  // namespace clevis::mechanism
