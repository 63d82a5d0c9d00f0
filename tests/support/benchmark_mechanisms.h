#pragma once

#include <string>

#include "support/bricard_equations.h"
#include "support/governor_equations.h"
#include "support/reference_motions.h"

/// Mechanisms by which multibody programs are commonly compared, with
/// formulations of their own.
namespace clevis::mechanism::testing {

inline MechanismDefinition governor(const Governor& v = {}) {
  using Eigen::Matrix3d;
  MechanismDefinition m;
  const auto body = [](const std::string& name, double mass, const Vector3d& p,
                       const Matrix3d& R, double centre, const Vector3d& turn) {
    BodyDefinition b;
    b.name = name;
    b.place = "body " + name;
    b.placement = {.p_WL = p, .R_WL = R};
    b.mass_properties.mass = mass;
    b.mass_properties.p_LCm = {0.0, 0.0, -centre};
    b.mass_properties.inertia_LCm = turn.asDiagonal();
    return b;
  };
  const Matrix3d same = Matrix3d::Identity();
  // z of a hinge along y of the shaft
  Matrix3d along_y;
  along_y << 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, -1.0, 0.0;
  m.bodies = {body("shaft", 1.0, Vector3d::Zero(), same, 0.0,
                   Vector3d::Constant(v.shaft_spin)),
              body("sleeve", v.sleeve_mass, {0.0, 0.0, -v.start_depth()}, same,
                   0.0, Vector3d::Constant(v.sleeve_spin))};
  m.joints = {{.name = "bearing",
               .type = JointType::kRevolute,
               .body_a = kGround,
               .body_b = 0,
               .frame_a = {},
               .frame_b = {},
               .place = "joint bearing"},
              {.name = "guide",
               .type = JointType::kPrismatic,
               .body_a = 0,
               .body_b = 1,
               .frame_a = {},
               .frame_b = {},
               .place = "joint guide"}};
  for (const double side : {-1.0, 1.0}) {
    const std::string name = side < 0.0 ? "left" : "right";
    const Matrix3d R = Eigen::AngleAxisd(-side * v.angle, Vector3d::UnitY())
                           .toRotationMatrix();
    const int arm = static_cast<int>(m.bodies.size());
    m.bodies.push_back(body(name, v.arm_mass, Vector3d::Zero(), R, v.arm_centre,
                            {v.arm_transverse, v.arm_transverse, v.arm_axial}));
    m.joints.push_back({.name = "hinge_" + name,
                        .type = JointType::kRevolute,
                        .body_a = 0,
                        .body_b = arm,
                        .frame_a = {Vector3d::Zero(), along_y},
                        .frame_b = {Vector3d::Zero(), along_y},
                        .place = "joint hinge"});
    LineElement spring;
    spring.name = "spring_" + name;
    spring.line.kind = ElementLine::Kind::kDistance;
    spring.line.a = {.body = arm, .p_L = {0.0, 0.0, -v.middle}};
    spring.line.b = {.body = 1, .p_L = Vector3d::Zero()};
    spring.law = SpringLaw{
        .stiffness = v.stiffness, .damping = v.damping, .free = v.free};
    m.elements.push_back(spring);
  }
  m.initial_joints = {
      {.joint = 0, .position = {}, .rate = v.spin, .place = "initial"}};
  m.gravity_W = {0.0, 0.0, -v.g};
  return m;
}

/// Bricard's mechanism: five bars of 1 m, 1 kg and the ground along six edges
/// of a cube, hinged about the third edge of each corner; at rest, under
/// gravity along −y. One of its 30 constraints is redundant.
inline MechanismDefinition bricard() {
  const std::array<Vector3d, 6> corners = bricard_corners();
  MechanismDefinition m;
  for (std::size_t i = 0; i < 5; ++i) {  // from corner i to the next
    BodyDefinition bar =
        uniform_bar("bar_" + std::to_string(i + 1), corners[i], 0.0, 1.0);
    bar.placement.R_WL = bricard_axes(i);
    bar.mass_properties.inertia_LCm = bricard_bar_inertia().asDiagonal();
    m.bodies.push_back(bar);
  }
  const auto rotation = [&m](int body) {
    return body == kGround
               ? Eigen::Matrix3d(Eigen::Matrix3d::Identity())
               : m.bodies[static_cast<std::size_t>(body)].placement.R_WL;
  };
  for (int i = 0; i < 6; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Vector3d before = corners[at] - corners[(at + 5) % 6];
    const Vector3d along = corners[(at + 1) % 6] - corners[at];
    Eigen::Matrix3d axes;  // x along the bar before
    axes.col(0) = before;
    axes.col(2) = before.cross(along);
    axes.col(1) = axes.col(2).cross(axes.col(0));
    const int a = i - 1, b = i == 5 ? kGround : i;
    const auto frame = [&](int body) {
      const Vector3d origin =
          body == kGround
              ? Vector3d(Vector3d::Zero())
              : m.bodies[static_cast<std::size_t>(body)].placement.p_WL;
      const Eigen::Matrix3d R = rotation(body);
      return JointFrame{R.transpose() * (corners[at] - origin),
                        R.transpose() * axes};
    };
    m.joints.push_back({.name = "hinge_" + std::to_string(i),
                        .type = JointType::kRevolute,
                        .body_a = a,
                        .body_b = b,
                        .frame_a = frame(a),
                        .frame_b = frame(b),
                        .place = "joint hinge"});
  }
  m.gravity_W = {0.0, -9.81, 0.0};
  return m;
}

}  // namespace clevis::mechanism::testing
