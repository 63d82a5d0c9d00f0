#pragma once

#include <string>

#include "support/free_linkages.h"

/// Motions by forces whose course is known to many digits.
namespace clevis::mechanism::testing {

/// Instants at even times until `duration` [s].
inline SimulationSettings sampled(double duration, int instants,
                                  double tolerance) {
  SimulationSettings s;
  s.duration = duration;
  s.instants = instants;
  s.tolerance = tolerance;
  return s;
}

/// A flywheel about the world's z, `inertia` about it.
inline MechanismDefinition flywheel(double inertia) {
  MechanismDefinition m;
  BodyDefinition wheel = uniform_bar("wheel", Vector3d::Zero(), 0.0, 0.1);
  wheel.mass_properties.p_LCm.setZero();
  wheel.mass_properties.inertia_LCm =
      Vector3d(inertia, inertia, inertia).asDiagonal();
  m.bodies = {wheel};
  m.joints = {{.name = "axle",
               .type = JointType::kRevolute,
               .body_a = kGround,
               .body_b = 0,
               .frame_a = {},
               .frame_b = {},
               .place = "joint"}};
  return m;
}

/// A free body of 2 kg.
inline MechanismDefinition free_body() {
  MechanismDefinition m;
  BodyDefinition body = uniform_bar("body", {0.1, 0.2, 0.3}, 0.0, 0.1);
  body.mass_properties.mass = 2.0;
  body.mass_properties.p_LCm.setZero();
  m.bodies = {body};
  return m;
}

/// Bodies that slide along x on ground, `mass` each.
inline MechanismDefinition sliders(const std::vector<double>& masses) {
  MechanismDefinition m;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    BodyDefinition body =
        uniform_bar("slider_" + std::to_string(i), Vector3d::Zero(), 0.0, 0.1);
    body.mass_properties.mass = masses[i];
    body.mass_properties.p_LCm.setZero();
    m.bodies.push_back(body);
    m.joints.push_back({.name = "guide_" + std::to_string(i),
                        .type = JointType::kPrismatic,
                        .body_a = kGround,
                        .body_b = static_cast<int>(i),
                        .frame_a = slide(1.0),
                        .frame_b = slide(1.0),
                        .place = "joint"});
  }
  return m;
}

inline LineElement on_joint(int joint, decltype(LineElement::law) law) {
  LineElement element;
  element.name = "element";
  element.line.kind = ElementLine::Kind::kJoint;
  element.line.joint = joint;
  element.law = law;
  return element;
}

/// Upper platform (0.5 kg, 1000 N/m) on a lower one that a law drives.
inline MechanismDefinition tribometer(const FrictionLaw& law) {
  MechanismDefinition m = sliders({1.0, 0.5});
  m.elements.push_back(on_joint(1, SpringLaw{.stiffness = 1000.0}));
  LineElement friction;
  friction.name = "friction";
  friction.line.kind = ElementLine::Kind::kSlide;
  friction.line.a.body = 0;
  friction.line.b.body = 1;
  friction.law = law;
  m.elements.push_back(friction);
  DriveDefinition drive;
  drive.joint = 0;
  drive.law = DriveLaw::kSine;
  drive.amplitude = 0.010;
  drive.frequency = 1.0;
  m.drives = {drive};
  // both start together
  m.initial_joints = {{.joint = 1,
                       .position = {},
                       .rate = 0.010 * 2.0 * M_PI,
                       .place = "initial"}};
  return m;
}

/// Mass 1 kg pulled over rough ground by a spring whose end moves at 0.1 m/s.
inline MechanismDefinition pulled(const FrictionLaw& law) {
  MechanismDefinition m = sliders({1.0, 1.0});
  LineElement spring;
  spring.line.kind = ElementLine::Kind::kSlide;
  spring.line.a.body = 0;
  spring.line.b.body = 1;
  spring.law = SpringLaw{.stiffness = 2.0};
  m.elements = {spring, on_joint(1, law)};
  DriveDefinition drive;
  drive.joint = 0;
  drive.law = DriveLaw::kRamp;
  drive.to = 10.0;
  drive.duration = 100.0;
  m.drives = {drive};
  return m;
}

inline FrictionLaw bristles() {
  return {.model = FrictionModel::kLuGre,
          .breakaway = 1.5,
          .kinetic = 1.0,
          .viscous = 0.4,
          .stribeck_speed = 0.001,
          .bristle_stiffness = 1e5,
          .bristle_damping = std::sqrt(1e5)};
}

/// 1 kg on 100 N/m that starts at rest, 0.1 m away from the wall at x = 0.
inline MechanismDefinition against_a_wall(const ContactLaw& law) {
  MechanismDefinition m = sliders({1.0});
  m.elements.push_back(on_joint(0, SpringLaw{.stiffness = 100.0}));
  m.elements.push_back(
      on_joint(0, StopLaw{.lower = 0.0, .upper = {}, .contact = law}));
  m.initial_joints = {
      {.joint = 0, .position = 0.1, .rate = {}, .place = "initial"}};
  return m;
}

/// Crank 0.08 m about x in (0, 0.1, 0.12), upright at 6 rad/s; rod 0.3 m on a
/// ball; slider of 2 kg on the x axis, hinged to the rod by a universal joint.
inline MechanismDefinition spatial_slider_crank() {
  MechanismDefinition m;
  const auto body = [](const std::string& name, double mass, const Vector3d& p,
                       const Eigen::Matrix3d& R, const Vector3d& center,
                       const Vector3d& inertia) {
    BodyDefinition b;
    b.name = name;
    b.place = "body " + name;
    b.placement = {.p_WL = p, .R_WL = R};
    b.mass_properties.mass = mass;
    b.mass_properties.p_LCm = center;
    b.mass_properties.inertia_LCm = inertia.asDiagonal();
    return b;
  };
  const Eigen::Matrix3d same = Eigen::Matrix3d::Identity();
  const Vector3d pivot(0.0, 0.1, 0.12), ball(0.0, 0.1, 0.2);
  const Vector3d end(0.2, 0.0, 0.0);
  Eigen::Matrix3d along;  // x from ball to end, y across world x
  along.col(0) = (end - ball).normalized();
  along.col(1) = Vector3d::UnitX().cross(along.col(0)).normalized();
  along.col(2) = along.col(0).cross(along.col(1));
  m.bodies = {
      body("crank", 0.12, pivot, same, {0.0, 0.0, 0.04},
           Vector3d::Constant(1e-4)),
      body("rod", 0.5, ball, along, {0.15, 0.0, 0.0}, {4e-4, 4e-3, 4e-3}),
      body("slider", 2.0, end, same, Vector3d::Zero(),
           Vector3d::Constant(1e-3))};
  Eigen::Matrix3d z_along_x;  // columns: axes of J
  z_along_x << 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0;
  const auto joint = [](const std::string& name, JointType type, int a, int b,
                        const JointFrame& on_a, const JointFrame& on_b) {
    return JointDefinition{.name = name,
                           .type = type,
                           .body_a = a,
                           .body_b = b,
                           .frame_a = on_a,
                           .frame_b = on_b,
                           .place = "joint " + name};
  };
  Eigen::Matrix3d across;  // x along y of the rod, z along its length
  across << 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0;
  m.joints = {
      joint("crank", JointType::kRevolute, kGround, 0, {pivot, z_along_x},
            {Vector3d::Zero(), z_along_x}),
      joint("ball", JointType::kSpherical, 0, 1, {{0.0, 0.0, 0.08}, same},
            {Vector3d::Zero(), same}),
      joint("hinge", JointType::kUniversal, 2, 1, {Vector3d::Zero(), z_along_x},
            {{0.3, 0.0, 0.0}, across}),
      joint("guide", JointType::kPrismatic, kGround, 2,
            {Vector3d::Zero(), z_along_x}, {Vector3d::Zero(), z_along_x})};
  m.gravity_W = {0.0, 0.0, -9.81};
  m.initial_joints = {
      {.joint = 0, .position = {}, .rate = 6.0, .place = "initial"}};
  return m;
}

}  // namespace clevis::mechanism::testing
