#pragma once

#include <vector>

#include <Eigen/Core>

#include "mechanism/joints/joint_model.h"

namespace clevis::mechanism {

/// Positions of all bodies by slot; slot 0 is ground. Joints that count turns
/// also need the angle that they have turned by.
struct Configuration : std::vector<BodyPlacement> {
  using std::vector<BodyPlacement>::vector;
  /// By joint, to half a turn [rad]; move() keeps it up. Empty: all 0.
  std::vector<double> angles;

  /// Angle of a joint [rad].
  double angle(std::size_t joint) const {
    return joint < angles.size() ? angles[joint] : 0.0;
  }
};

/// Where bodies and joints are in the frame P in which a mechanism is solved.
/// Each body is referred to a point M of its own.
struct ReferenceFrame {
  Eigen::Matrix3d R_WP = Eigen::Matrix3d::Identity();
  std::vector<Eigen::Vector3d> p_LM;  ///< by body [m]
  std::vector<JointModel> joints;
};

}  // namespace clevis::mechanism
