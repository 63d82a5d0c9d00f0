#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "mechanism/definition/definition.h"
#include "support/landing_gear.h"

/// Bennett's loop of four hinges: opposite links alike, lengths a, b and
/// twists alpha, beta with a / sin alpha = b / sin beta.
namespace clevis::mechanism::testing {

struct Bennett {
  double a = 1.0, alpha = std::numbers::pi / 3.0, beta = std::numbers::pi / 6.0;

  double b() const { return a * std::sin(beta) / std::sin(alpha); }
  /// Angle of the second hinge for that of the first.
  double second(double theta) const {
    const double product =
        std::sin(0.5 * (beta + alpha)) / std::sin(0.5 * (beta - alpha));
    return 2.0 * std::atan(product / std::tan(0.5 * theta));
  }
};

/// Frame at the far hinge of a link: x along the link, z turned by its twist.
inline JointFrame link_end(double length, double twist) {
  return {{length, 0.0, 0.0},
          Eigen::AngleAxisd(twist, Vector3d::UnitX()).toRotationMatrix()};
}

/// Links P, Q, R on hinges 1 to 4; ground is the fourth link. Each body's
/// frame stands at its first hinge. Drive on hinge 1.
inline MechanismDefinition bennett(const Bennett& l, double theta) {
  MechanismDefinition m;
  const double angles[] = {theta, l.second(theta), -theta};
  const double lengths[] = {l.a, l.b(), l.a};
  const double twists[] = {l.alpha, l.beta, l.alpha};
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  const auto joint = [&m](int a, int b, const JointFrame& on_a,
                          const JointFrame& on_b) {
    const std::string name = std::to_string(m.joints.size() + 1);
    m.joints.push_back({.name = name,
                        .type = JointType::kRevolute,
                        .body_a = a,
                        .body_b = b,
                        .frame_a = on_a,
                        .frame_b = on_b,
                        .place = "joint " + name});
  };
  JointFrame from = at(0.0, 0.0);
  for (int i = 0; i < 3; ++i) {
    X.rotate(turned(angles[i]));
    BodyDefinition body;
    body.name = std::string(1, static_cast<char>('P' + i));
    body.place = "body " + body.name;
    body.placement = {X.translation(), X.linear()};
    body.mass_properties = bar(1.0, 0.5 * lengths[i], 0.03, 0.08);
    m.bodies.push_back(body);
    joint(i - 1, i, from, at(0.0, 0.0));
    from = link_end(lengths[i], twists[i]);
    X.translate(from.p_LJ);
    X.rotate(from.R_LJ);
  }
  // from hinge 4, along the fourth link, to hinge 1
  const Matrix3d back = link_end(0.0, -l.beta).R_LJ;
  joint(2, kGround, from, {Vector3d(-l.b(), 0.0, 0.0), back});
  DriveDefinition drive;
  drive.law = DriveLaw::kQuintic;
  drive.from = theta;
  drive.to = theta + 1.0;
  drive.duration = 1.0;
  drive.place = "drive 1";
  m.drives = {drive};
  m.gravity_W = {0.0, 0.0, -9.81};
  return m;
}

}  // namespace clevis::mechanism::testing
