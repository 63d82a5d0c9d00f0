#pragma once

#include "support/landing_gear.h"
#include "support/planar_linkage.h"

namespace clevis::mechanism::testing {

/// A planar linkage as clevis takes it; the first joint's rate singles out the
/// motion.
inline MechanismDefinition definition_of(const PlanarLinkage& linkage) {
  MechanismDefinition m;
  const auto in_space = [](const Eigen::Vector2d& p) {
    return Vector3d(p.x(), p.y(), 0.0);
  };
  for (const PlanarBody& values : linkage.bodies) {
    BodyDefinition body;
    body.name = values.name;
    body.place = "body " + values.name;
    body.placement = {.p_WL = in_space(values.origin),
                      .R_WL = turned(values.angle)};
    body.mass_properties.mass = values.mass;
    body.mass_properties.p_LCm = in_space(values.centre);
    body.mass_properties.inertia_LCm = values.inertia * Matrix3d::Identity();
    m.bodies.push_back(body);
  }
  for (const PlanarJoint& joint : linkage.joints) {
    m.joints.push_back(
        {.name = joint.name,
         .type = joint.slides ? JointType::kPrismatic : JointType::kRevolute,
         .body_a = joint.a < 0 ? kGround : joint.a,
         .body_b = joint.b,
         .frame_a =
             joint.slides ? slide(1.0) : at(joint.p_a.x(), joint.p_a.y()),
         .frame_b =
             joint.slides ? slide(1.0) : at(joint.p_b.x(), joint.p_b.y()),
         .place = "joint " + joint.name});
  }
  for (const PlanarSpring& values : linkage.springs) {
    LineElement spring;
    spring.name = "spring";
    spring.line.kind = ElementLine::Kind::kDistance;
    spring.line.a = {.body = values.a < 0 ? kGround : values.a,
                     .p_L = in_space(values.p_a)};
    spring.line.b = {.body = values.b, .p_L = in_space(values.p_b)};
    spring.law = SpringLaw{.stiffness = values.stiffness, .free = values.free};
    m.elements.push_back(spring);
  }
  if (linkage.turned >= 0) {
    ConstantForce motor;
    motor.name = "motor";
    motor.point = {.body = linkage.turned, .p_L = Vector3d::Zero()};
    motor.t_W = {0.0, 0.0, linkage.torque};
    m.elements.push_back(motor);
  }
  const double rate = linkage.rate(linkage.joints[0]);
  if (rate != 0.0) {
    m.initial_joints = {
        {.joint = 0, .position = {}, .rate = rate, .place = "initial"}};
  }
  m.gravity_W = {0.0, -linkage.gravity, 0.0};
  return m;
}

}  // namespace clevis::mechanism::testing
