#pragma once

#include <Eigen/Core>

namespace clevis::part {

/// Mass, centre and inertia of a rigid body.
struct MassProperties {
  double mass{};           ///< [kg]
  Eigen::Vector3d p_LCm =  ///< centre of mass from Lo, in L [m]
      Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia_LCm =  ///< about the centre of mass, in L [kg m²]
      Eigen::Matrix3d::Zero();
};

}  // namespace clevis::part
