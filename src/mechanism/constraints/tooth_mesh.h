#pragma once

#include <Eigen/Core>

#include "mechanism/definition/meshing_wheels.h"
#include "mechanism/joints/joint_model.h"

namespace clevis::mechanism {

/// Teeth of two wheels with parallel axes, or of a rack (wheel 1) and its
/// pinion (wheel 2), in mesh.
struct ToothMesh {
  int wheel_1{}, wheel_2{};  ///< slots
  int carrier{};             ///< slot of what guides wheel 1
  /// 1 where the wheel is body b of its joint, −1 where it is a.
  double side_1{}, side_2{};
  JointRow row_1, row_2;
  PitchCircles circles;  ///< of two wheels
  double radius{};       ///< of a rack's pinion, of the coupling's sign [m]
  double radial{};       ///< tan of the transverse pressure angle [1]
  double axial{};     ///< tan of the helix angle, > 0: wheel 1 right-handed [1]
  double mid_face{};  ///< see ToothGeometry [m]
};

/// Where teeth touch, and what they press with, in P.
struct ToothContact {
  Eigen::Vector3d force;  ///< on wheel 1 [N]
  Eigen::Vector3d point;  ///< pitch point [m]
};

/// The force whose moment, or of a rack whose part along it, the coupling
/// hands on, with what the teeth's angles add to it. It pushes the wheels
/// apart, whichever flank carries it. Source: docs/theory.md, "Teeth".
/// @param effort  generalised force on the coordinate of joint 1 [N m] or [N].
ToothContact tooth_contact(const ToothMesh& mesh, const PlacedJoint& joint_1,
                           const PlacedJoint& joint_2, double effort);

}  // namespace clevis::mechanism
