#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "mechanism/definition/definition.h"

/// The landing gear of geometry/landing_gear, built without a scene
/// file; masses are round numbers of the parts' order.
namespace clevis::mechanism::testing {

using Eigen::Matrix3d;
using Eigen::Vector3d;

inline constexpr double kFD = 0.21024, kED = 0.060, kDC = 0.140, kEC = 0.145;
inline constexpr double kAD = 0.060, kAB = 0.140, kBC = 0.060;

enum LandingGearBody { kBodyAB, kBodyBC, kWheel, kBodyDCE, kFE1, kFE2 };
enum LandingGearJoint { kA, kB, kC, kD, kE, kF, kCylinder, kAxle };

inline Matrix3d turned(double angle) {
  return Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
}

inline JointFrame at(double x, double y) {
  return {.p_LJ = {x, y, 0.0}, .R_LJ = Matrix3d::Identity()};
}

/// z along ±x of the body, x along its z.
inline JointFrame slide(double sign) {
  Matrix3d R;
  R.col(2) = sign * Vector3d::UnitX();
  R.col(0) = Vector3d::UnitZ();
  R.col(1) = R.col(2).cross(R.col(0));
  return {.p_LJ = Vector3d::Zero(), .R_LJ = R};
}

inline part::MassProperties bar(double mass, double x, double y,
                                double inertia) {
  part::MassProperties m;
  m.mass = mass;
  m.p_LCm = {x, y, 0.0};
  m.inertia_LCm = Vector3d(0.1 * inertia, 0.9 * inertia, inertia).asDiagonal();
  return m;
}

/// Angles of the closed-form solution at cylinder length lx: q1 and the
/// direction theta of DC.
struct LandingGearAngles {
  double q1{}, theta{}, cylinder{};
};

inline LandingGearAngles landing_gear_angles(double lx, double DD1) {
  LandingGearAngles angles;
  angles.q1 = std::acos((kFD * kFD + kED * kED - lx * lx) / (2.0 * kFD * kED));
  const double EDC =
      std::acos((kED * kED + kDC * kDC - kEC * kEC) / (2.0 * kED * kDC));
  const double q3 = angles.q1 - std::acos(DD1 / kFD);
  angles.theta = std::numbers::pi - q3 - EDC;
  const double DE = angles.theta + EDC;  // direction of DE
  const double Fy = kAD - std::sqrt(kFD * kFD - DD1 * DD1);
  angles.cylinder =
      std::atan2(kAD + kED * std::sin(DE) - Fy, kED * std::cos(DE) + DD1);
  return angles;
}

/// @param DD1  horizontal distance of F from D [m].
/// @param lx   cylinder length of the placement [m].
inline MechanismDefinition landing_gear(double DD1 = 0.210, double lx = 0.160) {
  MechanismDefinition m;
  const LandingGearAngles angles = landing_gear_angles(lx, DD1);
  const Vector3d A = Vector3d::Zero(), D(0.0, kAD, 0.0);
  const Vector3d F(-DD1, kAD - std::sqrt(kFD * kFD - DD1 * DD1), 0.0);
  const Matrix3d R_DCE = turned(angles.theta);
  const double Ex = (kED * kED + kDC * kDC - kEC * kEC) / (2.0 * kDC);
  const double Ey = std::sqrt(kED * kED - Ex * Ex);
  const Vector3d C = D + R_DCE * Vector3d(kDC, 0.0, 0.0);
  const Vector3d E = D + R_DCE * Vector3d(Ex, Ey, 0.0);
  const double down = -0.5 * std::numbers::pi;
  const double pi = std::numbers::pi;
  const auto body = [&m](const char* name, const Vector3d& p, double angle,
                         const part::MassProperties& mass) {
    BodyDefinition b;
    b.name = name;
    b.placement = {.p_WL = p, .R_WL = turned(angle)};
    b.mass_properties = mass;
    b.place = std::string("body ") + name;
    m.bodies.push_back(b);
  };
  body("AB", A, angles.theta, bar(0.11, 0.07, 0.0, 2.5e-4));
  body("BC", C, down, bar(0.10, 0.05, 0.0, 1.2e-4));
  body("wheel", C + Vector3d(0.0, -0.1, 0.0), down,
       bar(0.30, 0.0, 0.0, 0.5 * 0.3 * 0.04 * 0.04));
  body("DCE", D, angles.theta, bar(0.35, 0.05, 0.02, 6e-4));
  body("FE1", F, angles.cylinder, bar(0.22, 0.08, 0.0, 5e-4));
  body("FE2", E, angles.cylinder + pi, bar(0.09, 0.07, 0.0, 2e-4));
  const auto joint = [&m](const char* name, JointType type, int a, int b,
                          const JointFrame& frame_a,
                          const JointFrame& frame_b) {
    m.joints.push_back({.name = name,
                        .type = type,
                        .body_a = a,
                        .body_b = b,
                        .frame_a = frame_a,
                        .frame_b = frame_b,
                        .place = std::string("joint ") + name});
  };
  const auto pin = [&joint](const char* name, int a, int b,
                            const JointFrame& on_a, const JointFrame& on_b) {
    joint(name, JointType::kRevolute, a, b, on_a, on_b);
  };
  pin("A", kGround, kBodyAB, at(0.0, 0.0), at(0.0, 0.0));
  pin("B", kBodyAB, kBodyBC, at(kAB, 0.0), at(kBC, 0.0));
  pin("C", kBodyDCE, kBodyBC, at(kDC, 0.0), at(0.0, 0.0));
  pin("D", kGround, kBodyDCE, at(D.x(), D.y()), at(0.0, 0.0));
  pin("E", kBodyDCE, kFE2, at(Ex, Ey), at(0.0, 0.0));
  pin("F", kGround, kFE1, at(F.x(), F.y()), at(0.0, 0.0));
  joint("cylinder", JointType::kPrismatic, kFE1, kFE2, slide(1.0), slide(-1.0));
  joint("axle", JointType::kWeld, kBodyBC, kWheel, at(0.1, 0.0), at(0.0, 0.0));
  DriveDefinition drive;
  drive.joint = kCylinder;
  drive.law = DriveLaw::kQuintic;
  drive.from = 0.160;
  drive.to = 0.260;
  drive.duration = 2.0;
  drive.place = "drive cylinder";
  m.drives.push_back(drive);
  m.gravity_W = {0.0, -9.81, 0.0};
  m.markers = {{"C", kBodyDCE, {kDC, 0.0, 0.0}},
               {"T", kBodyBC, {0.14, 0.0, 0.0}}};
  return m;
}

/// Wheel load (500 N, 1000 N) at a distance below C on BC [m].
inline ConstantForce wheel_load(double below_C) {
  return {.name = "wheel load",
          .point = {kBodyBC, {below_C, 0.0, 0.0}},
          .f_W = {500.0, 1000.0, 0.0},
          .t_W = Vector3d::Zero(),
          .place = "force wheel load"};
}

/// The mechanism at rest at one cylinder length.
inline void hold(MechanismDefinition& m, double lx) {
  m.drives[0].law = DriveLaw::kConstant;
  m.drives[0].from = m.drives[0].to = lx;
}

/// The same mechanism elsewhere: W' = R W + p.
inline MechanismDefinition moved(MechanismDefinition m, const Matrix3d& R,
                                 const Vector3d& p) {
  for (BodyDefinition& body : m.bodies) {
    body.placement.p_WL = R * body.placement.p_WL + p;
    body.placement.R_WL = R * body.placement.R_WL;
  }
  for (JointDefinition& joint : m.joints) {
    const auto move = [&](int body, JointFrame& frame) {
      if (body != kGround) return;
      frame.p_LJ = R * frame.p_LJ + p;
      frame.R_LJ = R * frame.R_LJ;
    };
    move(joint.body_a, joint.frame_a);
    move(joint.body_b, joint.frame_b);
  }
  for (ForceElement& element : m.elements) {
    if (auto* force = std::get_if<ConstantForce>(&element)) {
      force->f_W = R * force->f_W;
      force->t_W = R * force->t_W;
    }
  }
  m.gravity_W = R * m.gravity_W;
  return m;
}

}  // namespace clevis::mechanism::testing
