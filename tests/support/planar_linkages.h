#pragma once

#include <cmath>
#include <string>

#include "support/crank_rocker_equations.h"
#include "support/planar_linkage.h"

/// Planar mechanisms by which multibody programs are commonly compared.
namespace clevis::mechanism::testing {

/// Andrews' squeezing mechanism: seven bodies turned by a motor against a
/// spring, three of which meet at E. Start and numbers of the Test Set for IVP
/// Solvers.
inline PlanarLinkage andrews() {
  constexpr double kXa = -0.06934, kYa = -0.00227, kXb = -0.03635,
                   kYb = 0.03273, kXc = 0.014, kYc = 0.072;
  constexpr double d = 0.028, da = 0.0115, e = 0.02, ea = 0.01421, rr = 0.007,
                   ra = 0.00092, ss = 0.035, sa = 0.01874, sb = 0.01043,
                   sc = 0.018, sd = 0.02, ta = 0.02308, tb = 0.00916, u = 0.04,
                   ua = 0.01228, ub = 0.00449, zf = 0.02, zt = 0.04,
                   fa = 0.01421;
  constexpr double beta = -0.0617138900142764496358948458001, theta = 0.0,
                   gamma = 0.455279819163070380255912382449,
                   phi = 0.222668390165885884674473185609,
                   delta = 0.487364979543842550225598953530, omega = -phi,
                   epsilon = 1.23054744454982119249735015568;
  PlanarLinkage m;
  m.name = "andrews";
  const auto body = [&m](double mass, double inertia, double x, double y,
                         const Eigen::Vector2d& origin, double angle) {
    PlanarBody b;
    b.name = "K" + std::to_string(m.bodies.size() + 1);
    b.mass = mass;
    b.inertia = inertia;
    b.centre = {x, y};
    b.origin = origin;
    b.angle = angle;
    m.bodies.push_back(b);
  };
  const Eigen::Vector2d A(kXa, kYa), B(kXb, kYb);
  body(0.04325, 2.194e-6, ra, 0.0, {0.0, 0.0}, beta);
  body(0.00365, 4.410e-7, -da, 0.0, m.bodies[0].at({rr, 0.0}), beta + theta);
  body(0.02373, 5.255e-6, sb, -sa, B, gamma);
  body(0.07050, 1.169e-5, ta, tb, A, delta);  // K5
  body(0.00706, 5.667e-7, 0.0, ea - e, m.bodies[3].at({zt, 0.0}), phi + delta);
  body(0.05498, 1.912e-5, -ub, -ua, A, epsilon);  // K7
  body(0.00706, 5.667e-7, zf - fa, 0.0, m.bodies[5].at({0.0, -u}),
       omega + epsilon);
  m.bodies[3].name = "K5";
  m.bodies[4].name = "K4";
  m.bodies[5].name = "K7";
  m.bodies[6].name = "K6";
  m.joints = {
      {"O", -1, 0, {0.0, 0.0}, {0.0, 0.0}}, {"F", 0, 1, {rr, 0.0}, {0.0, 0.0}},
      {"B", -1, 2, B, {0.0, 0.0}},          {"A5", -1, 3, A, {0.0, 0.0}},
      {"H", 3, 4, {zt, 0.0}, {0.0, 0.0}},   {"A7", -1, 5, A, {0.0, 0.0}},
      {"G", 5, 6, {0.0, -u}, {0.0, 0.0}},   {"E3", 1, 2, {-d, 0.0}, {0.0, -ss}},
      {"E4", 1, 4, {-d, 0.0}, {0.0, -e}},   {"E6", 1, 6, {-d, 0.0}, {zf, 0.0}}};
  m.springs = {{-1, 2, {kXc, kYc}, {sd, -sc}, 4530.0, 0.07785}};
  m.turned = 0;
  m.torque = 0.033;
  m.watched = 7;
  return m;
}

/// Cart of 1 mg on level rails; 1 kg at the end of a rod of 1 m without mass,
/// from the horizontal. The rod's inertia is that of the reference.
inline PlanarLinkage light_cart_pole() {
  PlanarLinkage m;
  m.name = "light_cart_pole";
  m.bodies.resize(2);
  m.bodies[0].name = "cart";
  m.bodies[0].mass = 1e-6;
  m.bodies[0].inertia = 1e-9;
  m.bodies[1].name = "pole";
  m.bodies[1].mass = 1.0;
  m.bodies[1].inertia = 1e-9;
  m.bodies[1].centre = {1.0, 0.0};
  m.joints = {{"rails", -1, 0, {0.0, 0.0}, {0.0, 0.0}, true},
              {"hinge", 0, 1, {0.0, 0.0}, {0.0, 0.0}}};
  m.gravity = 9.81;
  m.pointer = 1;
  m.slider = 0;
  return m;
}

/// A crank that turns round under gravity, with coupler and rocker.
inline PlanarLinkage crank_rocker(const CrankRocker& v = {}) {
  PlanarLinkage m;
  m.name = "crank_rocker";
  const auto start = v.at(v.angle);
  m.bodies.resize(3);
  for (std::size_t i = 0; i < 3; ++i) {
    PlanarBody& b = m.bodies[i];
    b.name = i == 0 ? "crank" : i == 1 ? "coupler" : "rocker";
    b.mass = v.mass(i);
    b.inertia = v.inertia(i);
    b.centre = {0.5 * v.length[i], 0.0};
    b.origin = start.origin[i];
    b.angle = start.angle[i];
    b.rate = v.spin * start.rate[i];
    b.velocity = v.spin * start.velocity[i];
  }
  m.joints = {{"O", -1, 0, {0.0, 0.0}, {0.0, 0.0}},
              {"P", 0, 1, {v.length[0], 0.0}, {0.0, 0.0}},
              {"G", -1, 2, {v.ground, 0.0}, {0.0, 0.0}},
              {"Q", 1, 2, {v.length[1], 0.0}, {v.length[2], 0.0}}};
  m.gravity = v.g;
  return m;
}

/// The mechanism of two_window_four_bar().
inline PlanarLinkage planar_two_window_four_bar() {
  PlanarLinkage m;
  m.name = "two_window_four_bar";
  const double up = 0.5 * M_PI;
  for (int i = 0; i < 5; ++i) {
    PlanarBody b;
    b.name = (i < 3 ? "upright_" : "level_") + std::to_string(i % 3);
    b.mass = 1.0;
    b.inertia = 1.0 / 12.0;
    b.centre = {0.5, 0.0};
    b.angle = i < 3 ? up : 0.0;
    b.origin = {i % 3, i < 3 ? 0.0 : 1.0};
    b.rate = i < 3 ? -1.0 : 0.0;
    b.velocity = {i < 3 ? 0.0 : 1.0, 0.0};
    m.bodies.push_back(b);
  }
  m.joints = {{"A0", -1, 0, {0.0, 0.0}, {0.0, 0.0}},
              {"A1", -1, 1, {1.0, 0.0}, {0.0, 0.0}},
              {"A2", -1, 2, {2.0, 0.0}, {0.0, 0.0}},
              {"B0", 0, 3, {1.0, 0.0}, {0.0, 0.0}},
              {"C1", 1, 4, {1.0, 0.0}, {0.0, 0.0}},
              {"B1", 1, 3, {1.0, 0.0}, {1.0, 0.0}},
              {"C2", 2, 4, {1.0, 0.0}, {1.0, 0.0}}};
  m.gravity = 9.81;
  return m;
}

}  // namespace clevis::mechanism::testing
