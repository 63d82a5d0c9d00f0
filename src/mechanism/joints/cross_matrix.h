#pragma once

#include <Eigen/Core>

namespace clevis::mechanism {

/// [v]×, so that [v]× u = v × u.
inline Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

}  // namespace clevis::mechanism
