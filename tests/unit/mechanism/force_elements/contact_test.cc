#include "mechanism/force_elements/contact.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "mechanism/simulate.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

using Eigen::Vector3d;
using testing::against_a_wall;
using testing::free_body;
using testing::on_joint;
using testing::sampled;
using testing::sliders;

double x_of(const Instant& instant, std::size_t body) {
  return instant.bodies[body].pose.p_WL.x();
}

// Linear spring and damper during contact: e = exp(−πz/√(1−z²)) if it may
// pull, exp(−2z/√(1−z²) atan(√(1−z²)/z)) if it lets go at zero force. The
// outer spring of 100 N/m, left out there, is beside 1e5 N/m.
TEST(Contact, MassAgainstAWall) {
  for (const auto model : {ContactModel::kPublished, ContactModel::kPenalty}) {
    const ContactLaw law{.model = model, .stiffness = 1e5, .damping = 20.0};
    auto m = against_a_wall(law);
    const Motion motion = simulate(m, sampled(0.5, 5001, 1e-9));
    ASSERT_GE(motion.events.size(), 2u);
    for (std::size_t k = 0; k < motion.events.size(); ++k) {
      EXPECT_EQ(motion.events[k].what, k % 2 == 0 ? "press" : "release");
    }
    const double touch = motion.events[0].t;
    EXPECT_NEAR(touch, M_PI / 20.0, 1e-9);
    // the spring turns the rebound's energy into its amplitude
    double amplitude = 0.0;
    for (const Instant& i : motion.instants) {
      if (i.t > touch) amplitude = std::max(amplitude, x_of(i, 0));
    }
    EXPECT_NEAR(amplitude / 0.1,
                model == ContactModel::kPublished ? 0.90538 : 0.90720, 2e-4);
    if (model == ContactModel::kPenalty) {
      EXPECT_NEAR(motion.events[1].t - touch, 9.7394e-3, 6e-6);
    }
    EXPECT_LT(motion.integration->relative_energy_error, 1e-8);
  }
}

TEST(Contact, StiffnessOf1e8KeepsTheEnergy) {
  auto m = against_a_wall({.stiffness = 1e8});
  const Motion motion = simulate(m, sampled(3.0, 31, 1e-8));
  EXPECT_LT(motion.integration->relative_energy_error, 1e-6);
  for (const Instant& i : motion.instants) {
    EXPECT_GT(x_of(i, 0), -1e-3);
  }
}

// A wheel on the floor: static depth m g/k, and never more friction than
// mu_s N.
TEST(Contact, WheelComesToRestOnTheFloor) {
  MechanismDefinition m;
  BodyDefinition wheel =
      testing::uniform_bar("wheel", {0.0, 0.0405, 0.0}, 0.0, 0.1);
  wheel.mass_properties.p_LCm.setZero();
  wheel.mass_properties.inertia_LCm = Vector3d(4e-4, 4e-4, 8e-4).asDiagonal();
  m.bodies = {wheel};
  m.gravity_W = {0.0, -9.81, 0.0};
  ContactElement contact;
  contact.center.body = 0;
  contact.radius = 0.04;
  contact.law = {.stiffness = 1e6, .damping = 1e3, .transition = 1e-4};
  contact.static_friction = 0.5;
  contact.kinetic_friction = 0.3;
  m.elements = {contact};
  InitialBodyState push;
  push.body = 0;
  push.v_WLo = {0.5, 0.0, 0.0};
  m.initial_bodies = {push};
  const Motion motion = simulate(m, sampled(1.0, 101, 1e-7));
  const Instant& end = motion.instants.back();
  EXPECT_NEAR(end.elements[0].effort, 9.81, 1e-3);
  for (const Instant& i : motion.instants) {
    EXPECT_LE(i.elements[0].friction, 0.5 * i.elements[0].effort + 1e-12);
    EXPECT_GE(i.elements[0].effort, 0.0);
  }
  // it rolls: v = w r, up to the creep of the law
  EXPECT_NEAR(end.bodies[0].v_WLo.x(), -0.04 * end.bodies[0].w_WL.z(), 2e-3);
  EXPECT_LT(motion.integration->relative_energy_error, 1e-5);
}

// A bounce by Hunt and Crossley's law; its speed does not depend on the
// stiffness or the exponent.
TEST(Contact, HuntCrossleyHasTheKnownRestitution) {
  for (const double exponent : {1.0, 1.5}) {
    MechanismDefinition m = sliders({1.0});
    const double c = 0.4, v = 1.0;
    m.elements = {
        on_joint(0, StopLaw{.lower = 0.0,
                            .upper = {},
                            .contact = {.model = ContactModel::kHuntCrossley,
                                        .stiffness = 1e6,
                                        .damping = c,
                                        .exponent = exponent}})};
    m.initial_joints = {
        {.joint = 0, .position = 0.1, .rate = -v, .place = "initial"}};
    const Motion motion = simulate(m, sampled(0.2, 21, 1e-10));
    // m v dv/dx = k xⁿ(1 + c x'): v − ln(1 + c v)/c is the same both ways
    double low = 0.0, high = v;
    const auto side = [c](double speed) {
      return speed - std::log1p(c * speed) / c;
    };
    for (int i = 0; i < 100; ++i) {
      const double out = 0.5 * (low + high);
      (side(-out) > side(v) ? high : low) = out;
    }
    ASSERT_EQ(motion.events.size(), 2u);
    EXPECT_NEAR(motion.events[0].t, 0.1, 1e-10);
    EXPECT_NEAR(motion.instants.back().bodies[0].v_WLo.x(), low, 1e-8);
  }
}

// A sphere that slides on a slope, whose normal leaves the plane of no joint:
// friction μ_k, then rolling; a free body is spatial.
TEST(Contact, SphereSlidesDownASlope) {
  MechanismDefinition m = free_body();
  const double r = 0.1, slope = 0.5, mu = 0.1;
  const Vector3d n(0.0, std::sin(slope), std::cos(slope));
  const double k = 1e6, mg = 2.0 * 9.81;
  m.bodies[0].placement.p_WL = (r - mg * n.z() / k) * n;
  m.bodies[0].mass_properties.inertia_LCm =
      0.4 * 2.0 * r * r * Eigen::Matrix3d::Identity();
  m.gravity_W = {0.0, 0.0, -9.81};
  ContactElement contact;
  contact.center.body = 0;
  contact.radius = r;
  contact.normal_L = n;
  contact.law = {.stiffness = k, .damping = 1e3};
  contact.static_friction = contact.kinetic_friction = mu;
  contact.critical_speed = 1e-6;
  m.elements = {contact};
  const Motion motion = simulate(m, sampled(0.5, 6, 1e-7));
  const Vector3d down(0.0, std::cos(slope), -std::sin(slope));
  const double a = 9.81 * (std::sin(slope) - mu * std::cos(slope));
  const double spin = mu * 9.81 * std::cos(slope) / (0.4 * r);
  ASSERT_LT(spin * r, a);  // it slips all the way
  const Instant& end = motion.instants.back();
  EXPECT_NEAR(end.bodies[0].v_WLo.dot(down), a * 0.5, 1e-5);
  EXPECT_NEAR(end.bodies[0].w_WL.norm(), spin * 0.5, 1e-4);
  EXPECT_NEAR(end.elements[0].effort, mg * n.z(), 1e-3);
}

}  // namespace
}  // namespace clevis::mechanism
