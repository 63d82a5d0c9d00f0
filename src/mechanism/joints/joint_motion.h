#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "mechanism/joints/joint_model.h"

namespace clevis::mechanism {

/// Relative motion of b against a, in the coordinates of a joint.
enum class JointMotionKind {
  kFixed,
  kTurn,   ///< about z
  kSlide,  ///< along z
  kTurnAndSlide,
  kScrew,      ///< turn about z
  kPlane,      ///< x, y, turn about z
  kUniversal,  ///< about z of a, then x of b
  kBall,       ///< quaternion of b in a
  kFree        ///< x, y, z, quaternion
};

/// @return nothing for joints without coordinates of their own.
std::optional<JointMotionKind> joint_motion_kind(JointType type, bool planar);

/// Coordinates and velocities; these are rates of coordinates, and of
/// quaternions the angular velocity in axes of a.
int coordinate_count(JointMotionKind kind);
int velocity_count(JointMotionKind kind);
/// Index of the turn about z among the coordinates, or −1.
int turn_coordinate(JointMotionKind kind);
/// Index of the coordinate that a row measures, or −1.
int measured_coordinate(JointMotionKind kind, const JointRow& row);
/// Index of a quaternion's first coordinate, or −1; its angular velocity
/// starts at the same index of the velocities.
int quaternion_coordinate(JointMotionKind kind);

/// All in axes of J on a.
struct JointMotion {
  Eigen::Matrix3d R_ab = Eigen::Matrix3d::Identity();
  Eigen::Vector3d d = Eigen::Vector3d::Zero();  ///< from J on a to J on b [m]
  /// Of J on b against a, per velocity. Directions stand still in a.
  std::array<Twist, 6> directions;
  /// Angular acceleration against a at constant velocities.
  Eigen::Vector3d turning = Eigen::Vector3d::Zero();

  /// @param slide_per_angle  of a screw [m/rad].
  /// @param q, u  coordinates [m], [rad], [1]; velocities [m/s], [rad/s].
  void set(JointMotionKind kind, double slide_per_angle, const double* q,
           const double* u);
};

/// The inverse of JointMotion::set().
/// @param motion  R_ab and d count. @param twist  of J on b against a.
/// @param turn  about z [rad]. @param q, u  are filled; q is near before, for
///   the sign of quaternions.
void read_joint_motion(JointMotionKind kind, const JointMotion& motion,
                       const Twist& twist, double turn, double* q, double* u);

}  // namespace clevis::mechanism
