#include "mechanism/constraints/tooth_mesh.h"

#include <cmath>

#include <Eigen/Geometry>

namespace clevis::mechanism {
namespace {

using Eigen::Vector3d;

ToothContact contact_of_gears(const ToothMesh& mesh, const PlacedJoint& joint_1,
                              const PlacedJoint& joint_2, double effort) {
  const Vector3d axis = joint_1.action(mesh.row_1).w;
  const Vector3d way = joint_2.p_b - joint_1.p_b;
  const Vector3d to_2 = (way - way.dot(axis) * axis).normalized();
  const Vector3d tangent = axis.cross(to_2);
  const double to_pitch = mesh.circles.to_pitch;
  const double force = mesh.side_1 * effort / to_pitch;
  const double apart = mesh.circles.is_internal() ? 1.0 : -1.0;
  const double hand = to_pitch > 0.0 ? -mesh.axial : mesh.axial;
  return {.force = force * tangent +
                   std::abs(force) * mesh.radial * apart * to_2 +
                   force * hand * axis,
          .point = joint_1.p_b + to_pitch * to_2 + mesh.mid_face * axis};
}

ToothContact contact_of_rack(const ToothMesh& mesh, const PlacedJoint& rack,
                             const PlacedJoint& pinion, double effort) {
  const Vector3d along = rack.action(mesh.row_1).v;
  const Vector3d axis = pinion.action(mesh.row_2).w;
  const Vector3d across = along.cross(axis);
  const double radius = mesh.side_1 * mesh.side_2 * mesh.radius;
  const Vector3d to_rack = radius > 0.0 ? across : Vector3d(-across);
  return {.force = mesh.side_1 * effort * along +
                   std::abs(effort) * mesh.radial * to_rack,
          .point = pinion.p_b + radius * across + mesh.mid_face * axis};
}

}  // namespace

ToothContact tooth_contact(const ToothMesh& mesh, const PlacedJoint& joint_1,
                           const PlacedJoint& joint_2, double effort) {
  return mesh.row_1.is_angle()
             ? contact_of_gears(mesh, joint_1, joint_2, effort)
             : contact_of_rack(mesh, joint_1, joint_2, effort);
}

}  // namespace clevis::mechanism
