#include "mechanism/joints/cardan_angles.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace clevis::mechanism {

using Eigen::Matrix3d;
using Eigen::Vector3d;

CardanAngles::CardanAngles(const Matrix3d& axes_a, const Matrix3d& axes_b) {
  const Matrix3d R = axes_a.transpose() * axes_b;
  angles = {std::atan2(-R(0, 1), R(1, 1)),
            std::asin(std::clamp(R(2, 1), -1.0, 1.0)),
            std::atan2(-R(2, 0), R(2, 2))};
  axes.col(0) = axes_a.col(2);
  axes.col(1) =
      std::cos(angles[0]) * axes_a.col(0) + std::sin(angles[0]) * axes_a.col(1);
  axes.col(2) = axes_b.col(1);
  const Vector3d e1 = axes.col(0), e2 = axes.col(1), e3 = axes.col(2);
  const double volume = e1.dot(e2.cross(e3));  // cos q2
  rate_axes.col(0) = e2.cross(e3) / volume;
  rate_axes.col(1) = e3.cross(e1) / volume;
  rate_axes.col(2) = e1.cross(e2) / volume;
}

double CardanAngles::bias(int k, const Vector3d& w_a,
                          const Vector3d& w_b) const {
  const Vector3d rates = rate_axes.transpose() * (w_b - w_a);
  // e_2 turns with a and about e_1
  const Vector3d w_2 = w_a + rates[0] * axes.col(0);
  const Vector3d drift = rates[0] * w_a.cross(axes.col(0)) +
                         rates[1] * w_2.cross(axes.col(1)) +
                         rates[2] * w_b.cross(axes.col(2));
  return -rate_axes.col(k).dot(drift);
}

}  // namespace clevis::mechanism
