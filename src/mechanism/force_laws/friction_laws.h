#pragma once

#include <Eigen/Core>

#include "mechanism/force_laws/force_element.h"

namespace clevis::mechanism {

/// Friction of a line at a speed, with derivatives: effort = load × per_load +
/// own, the load being 1 or the reaction that the friction follows.
struct FrictionEffort {
  double per_load{}, own{};
  double per_load_slope{}, own_slope{};  ///< by the speed
  double bristle_rate{};                 ///< LuGre
  double bristle_slope{};                ///< of that rate, by the speed
  double bristle_decay{};                ///< of that rate, by the bristle
};

/// @param mode  of ActingElement. @param bristle  LuGre: its deflection.
/// @param slack  speed below which speeds tell nothing: a regularizing speed
///   below that acts as that.
FrictionEffort friction_effort(const FrictionLaw& law, int mode, double speed,
                               double bristle, double slack = 0.0);

/// The same by the tangent at another speed and bristle.
FrictionEffort friction_along_tangent(const FrictionLaw& law,
                                      const FrictionEffort& at, double speed,
                                      double bristle);

/// Sliding friction of a contact over its normal force, against a sliding
/// velocity, and its derivative.
struct SlidingFriction {
  Eigen::Vector3d coefficient = Eigen::Vector3d::Zero();
  Eigen::Matrix3d slope = Eigen::Matrix3d::Zero();  ///< [s/m]
};
/// @param sliding  [m/s]. The coefficient rises to the static one at the
///   critical speed, at least `slack`, falls to the kinetic one beyond it;
///   smooth.
SlidingFriction sliding_friction(const ContactElement& contact,
                                 const Eigen::Vector3d& sliding,
                                 double slack = 0.0);

}  // namespace clevis::mechanism
