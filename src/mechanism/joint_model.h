#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "mechanism/definition.h"

namespace clevis::mechanism {

/// Which motions of the bodies a system of equations is about. A planar
/// mechanism moves in its plane only, but its parts also carry what acts
/// across it.
enum class Motions { kSpatial, kInPlane, kOutOfPlane };

/// Indices into a twist (v, ω) that these motions use; the plane's normal is z.
std::span<const int> twist_components(Motions motions);

/// One constrained (or measured) motion of frame J on b against frame J on a:
/// along or about an axis of J on a.
struct JointRow {
  enum class Kind { kTranslation, kRotation } kind{};
  int axis{};  ///< 0, 1, 2: x, y, z of frame J on body a
};

/// What a joint type holds, within the given motions. In the plane, frames
/// of revolutes and welds have z normal to it, of prismatic joints x.
/// This table, coordinate_row() and rotation_error() are all that a new joint
/// type needs.
std::span<const JointRow> constrained_rows(JointType type, Motions motions);

/// The motion that a drive of the joint prescribes. Welds have none.
JointRow coordinate_row(JointType type);

/// Position of a body's reference point M and orientation, in the solving
/// frame P.
struct BodyPlacement {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();

  /// Displaces M and turns by a rotation vector, both in P.
  void move(const Eigen::Vector3d& translation,
            const Eigen::Vector3d& rotation);
};

/// Velocity of M and angular velocity of a body; or accelerations.
struct Twist {
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
  Eigen::Vector3d w = Eigen::Vector3d::Zero();
};

/// A joint between bodies by slot (0 is ground), frames relative to M.
struct JointModel {
  JointType type{};
  int a{}, b{};  ///< slots
  JointFrame frame_a, frame_b;
};

/// A joint in a configuration: its axes and levers in P.
struct PlacedJoint {
  PlacedJoint(const JointModel& joint, const BodyPlacement& body_a,
              const BodyPlacement& body_b);

  /// Rotation vector from frame J on a to J on b [rad]; a revolute leaves
  /// out the turn about its axis.
  Eigen::Vector3d rotation_error() const;

  /// How far b is displaced against a in this row: [m] or [rad].
  double displacement(const JointRow& row) const;

  /// Force (or moment) on b at J per unit multiplier of the row, as (force,
  /// moment about M) on a and on b: the row of the constraint Jacobian.
  struct Levers {
    Twist a, b;
  };
  Levers levers(const JointRow& row) const;

  /// Second time derivative of the row that velocities alone cause.
  double bias(const JointRow& row, const Twist& twist_a,
              const Twist& twist_b) const;

  JointType type{};
  Eigen::Matrix3d axes_a, axes_b;  ///< columns: axes of J in P
  Eigen::Vector3d r_a, r_b;        ///< from M to J [m]
  Eigen::Vector3d p_b;             ///< J on b [m]
  Eigen::Vector3d d;               ///< from J on a to J on b [m]
};

}  // namespace clevis::mechanism
