#pragma once

#include <Eigen/Core>

namespace clevis::part {

/// Position and orientation of frame L in frame W.
struct Pose {
  Eigen::Vector3d p_WL = Eigen::Vector3d::Zero();      ///< [m]
  Eigen::Matrix3d R_WL = Eigen::Matrix3d::Identity();  ///< columns: axes of L
};

}  // namespace clevis::part
