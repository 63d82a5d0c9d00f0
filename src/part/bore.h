#pragma once

#include <Eigen/Core>

namespace clevis::part {

/// A circular cylindrical surface of a link: a bore that a pin fills, or the
/// outside of a piston. Frame L.
struct Bore {
  Eigen::Vector3d p_LC;    ///< middle of the axis [m]
  Eigen::Vector3d axis_L;  ///< unit vector
  double radius{};         ///< [m]
  double length{};         ///< along the axis [m]
};

}  // namespace clevis::part
