#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "mechanism/joints/joint_definition.h"
#include "mechanism/joints/joint_types.h"

namespace clevis::mechanism {

/// Position of a body's reference point M and orientation, in the solving
/// frame P.
struct BodyPlacement {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();

  /// Displaces M [m] and turns by a rotation vector [rad], both in P.
  void move(const Eigen::Vector3d& translation,
            const Eigen::Vector3d& rotation);
};

/// A vector of M and one of the body: linear and angular.
struct SpatialVector {
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
  Eigen::Vector3d w = Eigen::Vector3d::Zero();
};
/// Velocity of M [m/s] and angular velocity [rad/s].
using Twist = SpatialVector;
/// Acceleration of M [m/s²] and angular acceleration [rad/s²].
using SpatialAcceleration = SpatialVector;
/// Force [N] and moment about M [N m].
using SpatialForce = SpatialVector;

/// A joint between bodies by slot (0 is ground), frames relative to M.
struct JointModel {
  JointType type{};
  int a{}, b{};  ///< slots
  JointFrame frame_a, frame_b;
  double slide_per_angle{};  ///< of a screw [m/rad]
  double length{};           ///< of a distance joint [m]
  /// Of forces [m/N], then moments [rad/(N m)], along x, y, z of J.
  Eigen::Matrix<double, 6, 1> compliance =
      Eigen::Matrix<double, 6, 1>::Constant(1.0);
  /// The angle about its axis counts beyond a turn: a screw, or coupled.
  bool counts_turns = false;
};

/// A joint in a configuration: its axes and levers in P.
struct PlacedJoint {
  /// @param angle  near which the angle about the joint's axis lies, to half
  ///   a turn [rad].
  PlacedJoint(const JointModel& joint, const BodyPlacement& body_a,
              const BodyPlacement& body_b, double angle = 0.0);

  /// Rotation vector from frame J on a to J on b [rad]; joints that turn
  /// about z leave out that turn.
  Eigen::Vector3d rotation_error() const;

  /// Displacement of b against a in this row: [m] or [rad].
  double displacement(const JointRow& row) const;

  /// Force and moment on b at its J per unit multiplier of the row.
  SpatialForce action(const JointRow& row) const;

  /// The same as (force, moment about M) on a and on b: the row of the
  /// constraint Jacobian. Exact where the joint is closed.
  struct Levers {
    SpatialForce a, b;
  };
  Levers levers(const JointRow& row) const { return levers(action(row)); }
  Levers levers(const SpatialForce& action) const;

  /// Second time derivative of the row that velocities alone cause: [m/s²] or
  /// [rad/s²].
  double bias(const JointRow& row, const Twist& twist_a,
              const Twist& twist_b) const;

  /// Angle about the joint's axis, beyond half a turn as `angle` says [rad].
  double turned() const;

  JointType type{};
  double slide_per_angle{}, length{}, angle_near{};
  Eigen::Matrix3d axes_a, axes_b;  ///< columns: axes of J in P
  Eigen::Vector3d r_a, r_b;        ///< from M to J [m]
  Eigen::Vector3d p_b;             ///< J on b [m]
  Eigen::Vector3d d;               ///< from J on a to J on b [m]
};

}  // namespace clevis::mechanism
