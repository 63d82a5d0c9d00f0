#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "mechanism/element_base/element_properties.h"
#include "mechanism/element_base/force_line.h"
#include "mechanism/force_laws/contact_law.h"

namespace clevis::mechanism {

class ActingElement;
struct ReferenceFrame;

/// A sphere (a wheel, in the plane) on a plane, with regularised friction.
struct ContactElement {
  std::string name;
  ElementPoint center;
  double radius{};  ///< [m]
  ElementPoint plane;
  Eigen::Vector3d normal_L = Eigen::Vector3d::UnitY();  ///< away from it
  ContactLaw law;
  double static_friction{}, kinetic_friction{};  ///< [1]
  double critical_speed = 1e-3;                  ///< [m/s]
  std::string place;

  std::array<int, 2> bodies(const std::vector<JointDefinition>&) const {
    return {plane.body, center.body};
  }
};

/// Sliding friction of a contact over its normal force, against a sliding
/// velocity, and its derivative.
struct SlidingFriction {
  Eigen::Vector3d coefficient = Eigen::Vector3d::Zero();
  Eigen::Matrix3d slope = Eigen::Matrix3d::Zero();  ///< [s/m]
};
/// @param sliding  [m/s]. The coefficient rises to the static one at the
///   critical speed, at least the tolerance, falls to the kinetic one beyond
///   it; smooth.
SlidingFriction sliding_friction(const ContactElement& contact,
                                 const Eigen::Vector3d& sliding,
                                 double velocity_tolerance = 0.0);

ElementProperties properties(const ContactElement& contact);
/// @param contact  outlives the result.
std::unique_ptr<ActingElement> place(const ContactElement& contact,
                                     const ReferenceFrame& frame);

}  // namespace clevis::mechanism
