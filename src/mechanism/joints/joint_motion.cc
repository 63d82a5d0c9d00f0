#include "mechanism/joints/joint_motion.h"

#include <cmath>

#include <Eigen/Geometry>

namespace clevis::mechanism {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Kind = JointMotionKind;

const Vector3d kNone = Vector3d::Zero();

void turn_about_z(double angle, Matrix3d& R) {
  const double c = std::cos(angle), s = std::sin(angle);
  R << c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0;
}

Matrix3d rotation(const double* q) {
  return Eigen::Quaterniond(Eigen::Map<const Eigen::Vector4d>(q).normalized())
      .toRotationMatrix();
}

}  // namespace

std::optional<JointMotionKind> joint_motion_kind(JointType type, bool planar) {
  switch (type) {
    case JointType::kRevolute:
      return Kind::kTurn;
    case JointType::kPrismatic:
      return Kind::kSlide;
    case JointType::kWeld:
      return Kind::kFixed;
    case JointType::kPlanar:
      return Kind::kPlane;
    case JointType::kCylindrical:
      return planar ? Kind::kTurn : Kind::kTurnAndSlide;
    case JointType::kSpherical:
      return planar ? Kind::kTurn : Kind::kBall;
    case JointType::kUniversal:
      return Kind::kUniversal;
    case JointType::kScrew:
      return Kind::kScrew;
    case JointType::kDistance:
    case JointType::kPointOnLine:
      break;
  }
  return std::nullopt;
}

int velocity_count(Kind kind) {
  constexpr std::array kCounts{0, 1, 1, 2, 1, 3, 2, 3, 6};
  return kCounts[static_cast<std::size_t>(kind)];
}

int coordinate_count(Kind kind) {
  return velocity_count(kind) + (quaternion_coordinate(kind) < 0 ? 0 : 1);
}

int turn_coordinate(Kind kind) {
  switch (kind) {
    case Kind::kTurn:
    case Kind::kTurnAndSlide:
    case Kind::kScrew:
    case Kind::kUniversal:
      return 0;
    case Kind::kPlane:
      return 2;
    default:
      return -1;
  }
}

int measured_coordinate(Kind kind, const JointRow& row) {
  if (row.kind == JointRow::Kind::kUniversal) {
    return kind == Kind::kUniversal && row.axis < 2 ? row.axis : -1;
  }
  if (row.kind == JointRow::Kind::kRotation) {
    return row.axis == 2 && kind != Kind::kUniversal ? turn_coordinate(kind)
                                                     : -1;
  }
  if (row.kind != JointRow::Kind::kTranslation) return -1;
  switch (kind) {
    case Kind::kSlide:
      return row.axis == 2 ? 0 : -1;
    case Kind::kTurnAndSlide:
      return row.axis == 2 ? 1 : -1;
    case Kind::kPlane:
      return row.axis < 2 ? row.axis : -1;
    default:
      return -1;
  }
}

int quaternion_coordinate(Kind kind) {
  return kind == Kind::kBall ? 0 : kind == Kind::kFree ? 3 : -1;
}

void JointMotion::set(Kind kind, double slide_per_angle, const double* q,
                      const double* u) {
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(),
                 z = Vector3d::UnitZ();
  switch (kind) {
    case Kind::kFixed:
      break;
    case Kind::kSlide:
      d.z() = q[0];
      directions[0] = {z, kNone};
      break;
    case Kind::kTurn:
      turn_about_z(q[0], R_ab);
      directions[0] = {kNone, z};
      break;
    case Kind::kTurnAndSlide:
      turn_about_z(q[0], R_ab);
      d.z() = q[1];
      directions[0] = {kNone, z};
      directions[1] = {z, kNone};
      break;
    case Kind::kScrew:
      turn_about_z(q[0], R_ab);
      d.z() = slide_per_angle * q[0];
      directions[0] = {slide_per_angle * z, z};
      break;
    case Kind::kPlane:
      turn_about_z(q[2], R_ab);
      d = {q[0], q[1], 0.0};
      directions[0] = {x, kNone};
      directions[1] = {y, kNone};
      directions[2] = {kNone, z};
      break;
    case Kind::kUniversal: {
      turn_about_z(q[0], R_ab);
      const Vector3d x_b = R_ab.col(0);
      R_ab = R_ab * Eigen::AngleAxisd(q[1], x).toRotationMatrix();
      directions[0] = {kNone, z};
      directions[1] = {kNone, x_b};
      turning = u[0] * u[1] * z.cross(x_b);
      break;
    }
    case Kind::kBall:
    case Kind::kFree: {
      const int first = quaternion_coordinate(kind);
      R_ab = rotation(q + first);
      if (kind == Kind::kFree) {
        d = {q[0], q[1], q[2]};
        directions[0] = {x, kNone};
        directions[1] = {y, kNone};
        directions[2] = {z, kNone};
      }
      const auto at = static_cast<std::size_t>(first);
      directions[at] = {kNone, x};
      directions[at + 1] = {kNone, y};
      directions[at + 2] = {kNone, z};
      break;
    }
  }
}

void read_joint_motion(Kind kind, const JointMotion& motion, const Twist& twist,
                       double turn, double* q, double* u) {
  const Vector3d& v = twist.v;
  const Vector3d& w = twist.w;
  const int at = turn_coordinate(kind);
  if (at >= 0) {
    q[at] = turn;
    u[at] = w.z();
  }
  switch (kind) {
    case Kind::kSlide:
      q[0] = motion.d.z();
      u[0] = v.z();
      break;
    case Kind::kTurnAndSlide:
      q[1] = motion.d.z();
      u[1] = v.z();
      break;
    case Kind::kPlane:
    case Kind::kFree:
      for (int i = 0; i < (kind == Kind::kFree ? 3 : 2); ++i) {
        q[i] = motion.d[i];
        u[i] = v[i];
      }
      break;
    case Kind::kUniversal:
      q[1] = std::atan2(motion.R_ab(2, 1), motion.R_ab(2, 2));
      u[1] = motion.R_ab.col(0).dot(w);
      break;
    default:
      break;
  }
  const int first = quaternion_coordinate(kind);
  if (first < 0) return;
  Eigen::Map<Eigen::Vector4d> coefficients(q + first);
  const Eigen::Vector4d turned = Eigen::Quaterniond(motion.R_ab).coeffs();
  coefficients = coefficients.dot(turned) < 0.0 ? -turned : turned;
  for (int i = 0; i < 3; ++i) u[first + i] = w[i];
}

}  // namespace clevis::mechanism
