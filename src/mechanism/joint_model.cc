#include "mechanism/joint_model.h"

#include <array>
#include <cmath>

namespace clevis::mechanism {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr auto kT = JointRow::Kind::kTranslation;
constexpr auto kR = JointRow::Kind::kRotation;

struct TypeRows {
  std::span<const JointRow> spatial, in_plane, out_of_plane;
};

TypeRows type_rows(JointType type) {
  static constexpr std::array kRevolute{
      JointRow{kT, 0}, JointRow{kT, 1},  // in the plane
      JointRow{kT, 2}, JointRow{kR, 0}, JointRow{kR, 1}};
  static constexpr std::array kPrismatic{
      JointRow{kT, 1}, JointRow{kR, 0},  // in the plane
      JointRow{kT, 0}, JointRow{kR, 1}, JointRow{kR, 2}};
  static constexpr std::array kWeld{
      JointRow{kT, 0}, JointRow{kT, 1}, JointRow{kR, 2},  // in the plane
      JointRow{kT, 2}, JointRow{kR, 0}, JointRow{kR, 1}};
  const auto split = [](std::span<const JointRow> rows, std::size_t in_plane) {
    return TypeRows{rows, rows.first(in_plane), rows.subspan(in_plane)};
  };
  switch (type) {
    case JointType::kRevolute:
      return split(kRevolute, 2);
    case JointType::kPrismatic:
      return split(kPrismatic, 2);
    case JointType::kWeld:
      break;
  }
  return split(kWeld, 3);
}

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

std::span<const int> twist_components(Motions motions) {
  static constexpr std::array kAll{0, 1, 2, 3, 4, 5};
  static constexpr std::array kIn{0, 1, 5}, kOut{2, 3, 4};
  switch (motions) {
    case Motions::kInPlane:
      return kIn;
    case Motions::kOutOfPlane:
      return kOut;
    case Motions::kSpatial:
      break;
  }
  return kAll;
}

std::span<const JointRow> constrained_rows(JointType type, Motions motions) {
  const TypeRows rows = type_rows(type);
  switch (motions) {
    case Motions::kInPlane:
      return rows.in_plane;
    case Motions::kOutOfPlane:
      return rows.out_of_plane;
    case Motions::kSpatial:
      break;
  }
  return rows.spatial;
}

JointRow coordinate_row(JointType type) {
  return type == JointType::kPrismatic ? JointRow{kT, 2} : JointRow{kR, 2};
}

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
                         const BodyPlacement& body_b)
    : type(joint.type),
      axes_a(body_a.R * joint.frame_a.R_LJ),
      axes_b(body_b.R * joint.frame_b.R_LJ),
      r_a(body_a.R * joint.frame_a.p_LJ),
      r_b(body_b.R * joint.frame_b.p_LJ),
      p_b(body_b.p + r_b),
      d(p_b - body_a.p - r_a) {}

Vector3d PlacedJoint::rotation_error() const {
  return type == JointType::kRevolute
             ? axis_error(axes_a, axes_b.col(2))
             : rotation_vector(axes_b * axes_a.transpose());
}

double PlacedJoint::displacement(const JointRow& row) const {
  if (row.kind == kT) return axes_a.col(row.axis).dot(d);
  if (type == JointType::kRevolute && row.axis == 2) {
    return std::atan2(axes_a.col(1).dot(axes_b.col(0)),
                      axes_a.col(0).dot(axes_b.col(0)));
  }
  return axes_a.col(row.axis).dot(rotation_error());
}

PlacedJoint::Levers PlacedJoint::levers(const JointRow& row) const {
  const Vector3d e = axes_a.col(row.axis);
  if (row.kind == kR) return {{Vector3d::Zero(), -e}, {Vector3d::Zero(), e}};
  // both bodies feel the force at J on b, also where d is not zero
  return {{-e, e.cross(r_a + d)}, {e, r_b.cross(e)}};
}

double PlacedJoint::bias(const JointRow& row, const Twist& twist_a,
                         const Twist& twist_b) const {
  const Vector3d e = axes_a.col(row.axis);
  const Vector3d& w_a = twist_a.w;
  const Vector3d& w_b = twist_b.w;
  const Vector3d e_rate = w_a.cross(e);
  if (row.kind == kR) return e_rate.dot(w_b - w_a);
  const Vector3d v_ab = twist_b.v + w_b.cross(r_b) - twist_a.v - w_a.cross(r_a);
  const Vector3d centripetal =
      w_b.cross(w_b.cross(r_b)) - w_a.cross(w_a.cross(r_a));
  return e.dot(centripetal) + 2.0 * e_rate.dot(v_ab) + w_a.cross(e_rate).dot(d);
}

}  // namespace clevis::mechanism
