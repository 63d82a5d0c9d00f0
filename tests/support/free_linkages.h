#pragma once

#include <string>

#include "support/landing_gear.h"

/// Linkages without drives, with published motions.
namespace clevis::mechanism::testing {

/// A bar of 1 kg from the origin of its frame along x, turned by `angle`.
inline BodyDefinition uniform_bar(const std::string& name, const Vector3d& p,
                                  double angle, double length) {
  BodyDefinition bar;
  bar.name = name;
  bar.placement = {.p_WL = p, .R_WL = turned(angle)};
  bar.mass_properties.mass = 1.0;
  bar.mass_properties.p_LCm = {0.5 * length, 0.0, 0.0};
  const double turn = length * length / 12.0;
  bar.mass_properties.inertia_LCm =
      Eigen::Vector3d(1e-4, turn, turn).asDiagonal();
  bar.place = "body " + name;
  return bar;
}

inline JointDefinition pin(const std::string& name, int a, int b, double x_a,
                           double x_b, double y_a = 0.0) {
  return {.name = name,
          .type = JointType::kRevolute,
          .body_a = a,
          .body_b = b,
          .frame_a = at(x_a, y_a),
          .frame_b = at(x_b, 0.0),
          .place = "joint " + name};
}

/// Body of 1 kg that swings like a point mass 1 m below the pin, from the
/// horizontal: its centre is `lever` away from the pin, I/(m lever) + lever =
/// 1 m.
inline MechanismDefinition simple_pendulum(double lever) {
  MechanismDefinition m;
  BodyDefinition bob = uniform_bar("rod", Vector3d::Zero(), M_PI, 1.0);
  bob.mass_properties.p_LCm = {lever, 0.0, 0.0};
  const double turn = std::max(lever * (1.0 - lever), 1e-15);
  bob.mass_properties.inertia_LCm = turn * Eigen::Matrix3d::Identity();
  m.bodies = {bob};
  m.joints = {pin("O", kGround, 0, 0.0, 0.0)};
  m.gravity_W = {0.0, -9.81, 0.0};
  return m;
}

/// Three upright bars on ground, 1 m apart, under two level ones; the first
/// top corner moves at 1 m/s. All bars are 1 m, 1 kg. Passes the position in
/// which all bars lie level ten times in 10 s.
inline MechanismDefinition two_window_four_bar() {
  MechanismDefinition m;
  const double up = 0.5 * M_PI;
  for (int i = 0; i < 3; ++i) {
    m.bodies.push_back(uniform_bar("upright_" + std::to_string(i),
                                   {1.0 * i, 0.0, 0.0}, up, 1.0));
  }
  for (int i = 0; i < 2; ++i) {
    m.bodies.push_back(uniform_bar("level_" + std::to_string(i),
                                   {1.0 * i, 1.0, 0.0}, 0.0, 1.0));
  }
  for (int i = 0; i < 3; ++i) {
    m.joints.push_back(pin("A" + std::to_string(i), kGround, i, 1.0 * i, 0.0));
  }
  m.joints.push_back(pin("B0", 0, 3, 1.0, 0.0));
  m.joints.push_back(pin("B1", 1, 3, 1.0, 1.0));
  m.joints.push_back(pin("C1", 1, 4, 1.0, 0.0));
  m.joints.push_back(pin("C2", 2, 4, 1.0, 1.0));
  m.initial_joints = {
      {.joint = 0, .position = {}, .rate = -1.0, .place = "initial"}};
  m.gravity_W = {0.0, -9.81, 0.0};
  return m;
}

}  // namespace clevis::mechanism::testing
