#pragma once

#include <array>
#include <cmath>
#include <string>

#include "support/reference_motions.h"

/// Mechanisms by which multibody programs are commonly compared, with
/// formulations of their own.
namespace clevis::mechanism::testing {

/// Flyball governor: a shaft about the world's z; two arms of 1 m hinged to
/// its top, each with a ball at its end; a sleeve that slides down the shaft,
/// held to the middle of each arm by a stiff spring and damper.
struct Governor {
  double arm_mass = 6.0, arm_centre = 0.9;         ///< [kg], [m] from the hinge
  double arm_axial = 0.02, arm_transverse = 0.35;  ///< about the centre [kg m²]
  double sleeve_mass = 1.0, sleeve_spin = 0.1;     ///< [kg], [kg m²]
  double shaft_spin = 0.1;                         ///< [kg m²]
  double middle = 0.5;                             ///< of the arm [m]
  double stiffness = 8e5, damping = 4e4, free = 0.5;  ///< [N/m], [N s/m], [m]
  double angle = M_PI / 6.0;  ///< of the arms from downwards, at the start
  double spin = 2.0 * M_PI;   ///< at the start [rad/s]
  double g = 9.81;

  /// Depth of the sleeve at which the springs are free [m].
  double start_depth() const {
    const double across = middle * std::sin(angle);
    return middle * std::cos(angle) + std::sqrt(free * free - across * across);
  }
};

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

/// The same in three coordinates: depth of the sleeve, angle of both arms and
/// the spin that the angular momentum leaves.
class GovernorEquations {
 public:
  explicit GovernorEquations(const Governor& v)
      : v_(v),
        about_hinge_(v.arm_transverse +
                     v.arm_mass * v.arm_centre * v.arm_centre),
        y_{v.start_depth(), v.angle, 0.0, 0.0},
        momentum_(spin_inertia(v.angle) * v.spin) {}

  double depth() const { return y_[0]; }
  double angle() const { return y_[1]; }
  double spin() const { return momentum_ / spin_inertia(y_[1]); }

  /// Runge–Kutta of order 4, n steps.
  void advance(double duration, long n) {
    const double h = duration / static_cast<double>(n);
    for (long i = 0; i < n; ++i) {
      const State a = rate(y_), b = rate(along(a, 0.5 * h)),
                  c = rate(along(b, 0.5 * h)), d = rate(along(c, h));
      for (std::size_t k = 0; k < 4; ++k) {
        y_[k] += h / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]);
      }
    }
  }

 private:
  using State = std::array<double, 4>;

  State along(const State& slope, double h) const {
    State y = y_;
    for (std::size_t k = 0; k < 4; ++k) y[k] += h * slope[k];
    return y;
  }

  double spin_inertia(double angle) const {
    const double s = std::sin(angle), c = std::cos(angle);
    return v_.shaft_spin + v_.sleeve_spin +
           2.0 * (about_hinge_ * s * s + v_.arm_axial * c * c);
  }

  State rate(const State& y) const {
    const double depth = y[0], sine = std::sin(y[1]), cosine = std::cos(y[1]);
    const double h = v_.middle;
    const double length =
        std::sqrt(h * h + depth * depth - 2.0 * h * depth * cosine);
    const double by_depth = (depth - h * cosine) / length;
    const double by_angle = h * depth * sine / length;
    const double force = -v_.stiffness * (length - v_.free) -
                         v_.damping * (by_depth * y[2] + by_angle * y[3]);
    const double w = momentum_ / spin_inertia(y[1]);
    return {y[2], y[3], v_.g + 2.0 * force * by_depth / v_.sleeve_mass,
            ((about_hinge_ - v_.arm_axial) * sine * cosine * w * w -
             v_.arm_mass * v_.g * v_.arm_centre * sine + force * by_angle) /
                about_hinge_};
  }

  Governor v_;
  double about_hinge_;
  State y_;
  double momentum_;
};

/// Bricard's mechanism: five bars of 1 m, 1 kg and the ground along six edges
/// of a cube, hinged about the third edge of each corner; at rest, under
/// gravity along −y. One of its 30 constraints is redundant.
inline MechanismDefinition bricard() {
  const std::array<Vector3d, 6> corners{
      Vector3d(0.0, 0.0, 0.0),  Vector3d(1.0, 0.0, 0.0),
      Vector3d(1.0, -1.0, 0.0), Vector3d(1.0, -1.0, 1.0),
      Vector3d(0.0, -1.0, 1.0), Vector3d(0.0, 0.0, 1.0)};
  MechanismDefinition m;
  for (std::size_t i = 0; i < 5; ++i) {  // from corner i to the next
    const Vector3d along = corners[i + 1] - corners[i];
    const Vector3d before = corners[i] - corners[(i + 5) % 6];
    Eigen::Matrix3d R;
    R.col(0) = along;
    R.col(2) = before.cross(along);
    R.col(1) = R.col(2).cross(R.col(0));
    BodyDefinition bar =
        uniform_bar("bar_" + std::to_string(i + 1), corners[i], 0.0, 1.0);
    bar.placement.R_WL = R;
    bar.mass_properties.inertia_LCm =
        Vector3d(1e-4, 1.0 / 12.0, 1.0 / 12.0).asDiagonal();
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
