#include "mechanism/joints/joint_model.h"

#include <cmath>
#include <numbers>

#include "mechanism/joints/cardan_angles.h"

namespace clevis::mechanism {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Kind = JointRow::Kind;

/// Rotation vector of a rotation matrix, also near π.
Vector3d rotation_vector(const Matrix3d& R) {
  Eigen::Quaterniond q(R);
  if (q.w() < 0.0) q.coeffs() *= -1.0;
  const double s = q.vec().norm();
  // angle / sin(angle/2) → 2 as the angle vanishes
  return s < 1e-12 ? Vector3d(2.0 * q.vec())
                   : Vector3d(2.0 * std::atan2(s, q.w()) / s * q.vec());
}

/// Shortest rotation that takes unit vector z_a to z_b.
Vector3d axis_error(const Matrix3d& axes_a, const Vector3d& z_b) {
  const Vector3d cross = axes_a.col(2).cross(z_b);
  const double s = cross.norm(), c = axes_a.col(2).dot(z_b);
  if (s > 1e-9) return std::atan2(s, c) / s * cross;
  return c > 0.0 ? cross : Vector3d(std::atan2(0.0, -1.0) * axes_a.col(0));
}

}  // namespace

void BodyPlacement::move(const Vector3d& translation,
                         const Vector3d& rotation) {
  p += translation;
  const double angle = rotation.norm();
  // sin(angle/2)/angle, by its series where the quotient loses digits
  const double half = 0.5 * angle;
  const double factor =
      angle < 1e-4 ? 0.5 - angle * angle / 48.0 : std::sin(half) / angle;
  Eigen::Quaterniond turn;
  turn.w() = std::cos(half);
  turn.vec() = factor * rotation;
  q = (turn * q).normalized();
  R = q.toRotationMatrix();
}

PlacedJoint::PlacedJoint(const JointModel& joint, const BodyPlacement& body_a,
                         const BodyPlacement& body_b, double angle)
    : type(joint.type),
      slide_per_angle(joint.slide_per_angle),
      length(joint.length),
      angle_near(angle),
      axes_a(body_a.R * joint.frame_a.R_LJ),
      axes_b(body_b.R * joint.frame_b.R_LJ),
      r_a(body_a.R * joint.frame_a.p_LJ),
      r_b(body_b.R * joint.frame_b.p_LJ),
      p_b(body_b.p + r_b),
      d(p_b - body_a.p - r_a) {}

Vector3d PlacedJoint::rotation_error() const {
  return traits(type).keeps_orientation
             ? rotation_vector(axes_b * axes_a.transpose())
             : axis_error(axes_a, axes_b.col(2));
}

double PlacedJoint::turned() const {
  double angle = 0.0;
  const auto coordinates = traits(type).coordinates;
  const bool turns_freely =
      !coordinates.empty() && coordinates.back().row.kind == Kind::kCardan;
  if (turns_freely) {
    angle = CardanAngles(axes_a, axes_b).angles[0];
  } else {
    angle = std::atan2(axes_a.col(1).dot(axes_b.col(0)),
                       axes_a.col(0).dot(axes_b.col(0)));
  }
  constexpr double kTurn = 2.0 * std::numbers::pi;
  return angle + kTurn * std::round((angle_near - angle) / kTurn);
}

double PlacedJoint::displacement(const JointRow& row) const {
  switch (row.kind) {
    case Kind::kTranslation:
      return axes_a.col(row.axis).dot(d);
    case Kind::kRotation:
      if (row.axis == 2 && !traits(type).keeps_orientation) return turned();
      return axes_a.col(row.axis).dot(rotation_error());
    case Kind::kUniversal: {
      if (row.axis == 0) return turned();
      const Vector3d z = axes_a.col(2);
      return row.axis == 1
                 ? std::atan2(z.dot(axes_b.col(1)), z.dot(axes_b.col(2)))
                 : -std::asin(z.dot(axes_b.col(0)));
    }
    case Kind::kCardan:
      return row.axis == 0 ? turned()
                           : CardanAngles(axes_a, axes_b).angles[row.axis];
    case Kind::kScrew:
      return axes_a.col(2).dot(d) - slide_per_angle * turned();
    case Kind::kDistance:
      break;
  }
  return 0.5 * (d.squaredNorm() / length - length);
}

Twist PlacedJoint::action(const JointRow& row) const {
  const Vector3d none = Vector3d::Zero();
  switch (row.kind) {
    case Kind::kTranslation:
      return {axes_a.col(row.axis), none};
    case Kind::kRotation:
      return {none, axes_a.col(row.axis)};
    case Kind::kUniversal:
      if (row.axis == 0) return {none, axes_a.col(2)};
      if (row.axis == 1) return {none, axes_b.col(0)};
      return {none, axes_a.col(2).cross(axes_b.col(0))};
    case Kind::kCardan:
      return {none, CardanAngles(axes_a, axes_b).rate_axes.col(row.axis)};
    case Kind::kScrew:
      return {axes_a.col(2), -slide_per_angle * axes_a.col(2)};
    case Kind::kDistance:
      break;
  }
  return {d / length, none};
}

PlacedJoint::Levers PlacedJoint::levers(const SpatialForce& action) const {
  const Vector3d& f = action.v;
  const Vector3d& t = action.w;
  if (f.isZero(0.0)) return {{f, -t}, {f, t}};
  // both bodies feel the force at J on b, also where d is not zero
  return {{-f, f.cross(r_a + d) - t}, {f, r_b.cross(f) + t}};
}

double PlacedJoint::bias(const JointRow& row, const Twist& twist_a,
                         const Twist& twist_b) const {
  const Vector3d& w_a = twist_a.w;
  const Vector3d& w_b = twist_b.w;
  const Vector3d w_ab = w_b - w_a;
  switch (row.kind) {
    case Kind::kRotation:
      return w_a.cross(axes_a.col(row.axis)).dot(w_ab);
    case Kind::kUniversal: {
      const Vector3d z_a = axes_a.col(2), x_b = axes_b.col(0);
      const Vector3d z_rate = w_a.cross(z_a), x_rate = w_b.cross(x_b);
      if (row.axis == 0) return z_rate.dot(w_ab);
      if (row.axis == 1) return x_rate.dot(w_ab);
      return (z_rate.cross(x_b) + z_a.cross(x_rate)).dot(w_ab);
    }
    case Kind::kCardan:
      return CardanAngles(axes_a, axes_b).bias(row.axis, w_a, w_b);
    default:
      break;
  }
  const Vector3d v_ab = twist_b.v + w_b.cross(r_b) - twist_a.v - w_a.cross(r_a);
  const Vector3d centripetal =
      w_b.cross(w_b.cross(r_b)) - w_a.cross(w_a.cross(r_a));
  if (row.kind == Kind::kDistance) {
    return (v_ab.squaredNorm() + d.dot(centripetal)) / length;
  }
  const Vector3d e = axes_a.col(row.axis);
  const Vector3d e_rate = w_a.cross(e);
  const double slide =
      e.dot(centripetal) + 2.0 * e_rate.dot(v_ab) + w_a.cross(e_rate).dot(d);
  return row.kind == Kind::kScrew ? slide - slide_per_angle * e_rate.dot(w_ab)
                                  : slide;
}

}  // namespace clevis::mechanism
