#pragma once

#include <Eigen/Core>

#include "mechanism/equations_of_motion/equations_of_motion.h"

namespace clevis::mechanism {

/// Moves states y of StateLayout onto the constraints, as drives move these.
/// Times [s].
class Projection {
 public:
  /// @param equations  outlive this.
  explicit Projection(EquationsOfMotion& equations);

  /// Moves positions and velocities, by the least mass norm, onto the
  /// constraints at time t. @return the largest gap that is left [m].
  double project(double t, Eigen::VectorXd& y);
  /// Where drives jump: velocities change by the impulse that this takes,
  /// which does the work that is gained; dry friction has no part in it, its
  /// modes are to be chosen anew.
  void jump(double t, Eigen::VectorXd& y);
  /// Largest gap of joints and drives [m], turns × length.
  double gap(double t, const Eigen::VectorXd& y);

 private:
  double correct_positions(double t, Eigen::VectorXd& y);
  void correct_velocities(Eigen::VectorXd& y);

  EquationsOfMotion& equations_;
  DriveTargets targets_;  ///< of gap()
  Eigen::VectorXd residual_, change_;
};

}  // namespace clevis::mechanism
