#pragma once

#include <Eigen/Core>
#include <Eigen/QR>

#include "mechanism/dynamic_state/state_scales.h"
#include "mechanism/equations_of_motion/equations_of_motion.h"

namespace clevis::mechanism {

/// Directions in which the constraints let a state y of StateLayout change:
/// positions and velocities that joints and drives leave open, and internal
/// states.
class StateTangents {
 public:
  /// @param equations, scales  outlive this.
  StateTangents(EquationsOfMotion& equations, const StateScales& scales);

  /// Puts the directions at t [s] into the first columns of T, each as long as
  /// the scale of its states. @return how many.
  Eigen::Index put(double t, const Eigen::VectorXd& y, Eigen::MatrixXd& T);

 private:
  void put_open_velocities(const MechanismState& state);

  EquationsOfMotion& equations_;
  const StateScales& scales_;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> row_space_;
  Eigen::RowVectorXd row_workspace_;
  Eigen::MatrixXd open_;
  Eigen::VectorXd sizes_;
};

}  // namespace clevis::mechanism
