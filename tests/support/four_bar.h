#pragma once

#include <cmath>
#include <numbers>

#include "support/landing_gear.h"

/// Planar linkages with closed forms.
namespace clevis::mechanism::testing {

struct FourBar {
  double ground = 0.20, crank = 0.05, coupler = 0.18, rocker = 0.12;  ///< [m]
};

/// Angles, rates and accelerations of coupler and rocker.
struct FourBarMotion {
  double coupler{}, rocker{};
  double coupler_rate{}, rocker_rate{};
  double coupler_acceleration{}, rocker_acceleration{};
};

/// Freudenstein's equation, open branch, for crank angle φ and its
/// derivatives; pivots O = (0,0) and G = (ground, 0).
inline FourBarMotion freudenstein(const FourBar& l, double phi, double w,
                                  double alpha) {
  // K1 cos ψ − K2 cos φ + K3 = cos(φ − ψ), solved by tan(ψ/2)
  const double K1 = l.ground / l.crank, K2 = l.ground / l.rocker;
  const double K3 = (l.crank * l.crank - l.coupler * l.coupler +
                     l.rocker * l.rocker + l.ground * l.ground) /
                    (2.0 * l.crank * l.rocker);
  const double a = std::cos(phi) - K1 - K2 * std::cos(phi) + K3;
  const double b = -2.0 * std::sin(phi);
  const double c = K1 - (K2 + 1.0) * std::cos(phi) + K3;
  FourBarMotion m;
  m.rocker = 2.0 * std::atan2(-b - std::sqrt(b * b - 4.0 * a * c), 2.0 * a);
  m.coupler = std::atan2(
      l.rocker * std::sin(m.rocker) - l.crank * std::sin(phi),
      l.ground + l.rocker * std::cos(m.rocker) - l.crank * std::cos(phi));
  const double d = std::sin(m.coupler - m.rocker);
  m.coupler_rate = l.crank * w * std::sin(m.rocker - phi) / (l.coupler * d);
  m.rocker_rate = l.crank * w * std::sin(m.coupler - phi) / (l.rocker * d);
  const double wc2 = m.coupler_rate * m.coupler_rate;
  const double wr2 = m.rocker_rate * m.rocker_rate;
  // loop accelerations, projected on rocker and on coupler
  m.coupler_acceleration =
      (-l.crank * alpha * std::sin(phi - m.rocker) -
       l.crank * w * w * std::cos(phi - m.rocker) -
       l.coupler * wc2 * std::cos(m.coupler - m.rocker) + l.rocker * wr2) /
      (l.coupler * d);
  m.rocker_acceleration =
      (l.crank * alpha * std::sin(m.coupler - phi) -
       l.crank * w * w * std::cos(m.coupler - phi) - l.coupler * wc2 +
       l.rocker * wr2 * std::cos(m.coupler - m.rocker)) /
      (l.rocker * d);
  return m;
}

/// Bodies crank, coupler, rocker; joints O, P, Q, G; drive at O.
/// @param phi  crank angle of the placement.
inline MechanismDefinition four_bar(const FourBar& l, double phi) {
  MechanismDefinition m;
  const FourBarMotion at_phi = freudenstein(l, phi, 0.0, 0.0);
  const auto body = [&m](const char* name, const Vector3d& p, double angle,
                         double length) {
    BodyDefinition b;
    b.name = name;
    b.placement = {.p_WL = p, .R_WL = turned(angle)};
    b.mass_properties =
        bar(2.0 * length, 0.5 * length, 0.0, length * length * length / 6.0);
    b.place = std::string("body ") + name;
    m.bodies.push_back(b);
  };
  body("crank", Vector3d::Zero(), phi, l.crank);
  body("coupler", l.crank * Vector3d(std::cos(phi), std::sin(phi), 0.0),
       at_phi.coupler, l.coupler);
  body("rocker", {l.ground, 0.0, 0.0}, at_phi.rocker, l.rocker);
  const auto pin = [&m](const char* name, int a, int b, double on_a,
                        double on_b) {
    m.joints.push_back({.name = name,
                        .type = JointType::kRevolute,
                        .body_a = a,
                        .body_b = b,
                        .frame_a = at(on_a, 0.0),
                        .frame_b = at(on_b, 0.0),
                        .place = std::string("joint ") + name});
  };
  pin("O", kGround, 0, 0.0, 0.0);
  pin("P", 0, 1, l.crank, 0.0);
  pin("Q", 1, 2, l.coupler, l.rocker);
  pin("G", kGround, 2, l.ground, 0.0);
  DriveDefinition drive;
  drive.joint = 0;
  drive.law = DriveLaw::kRamp;
  drive.from = phi;
  drive.to = phi + 4.0 * std::numbers::pi;
  drive.duration = 1.0;
  drive.place = "drive O";
  m.drives.push_back(drive);
  m.gravity_W = {0.0, -9.81, 0.0};
  return m;
}

}  // namespace clevis::mechanism::testing
