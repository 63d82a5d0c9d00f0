// Stick and slip over whole motions, against closed forms of their pieces.
#include "mechanism/line_elements/friction.h"

#include <cmath>

#include <gtest/gtest.h>

#include "mechanism/simulate.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

using testing::flywheel;
using testing::on_joint;
using testing::pulled;
using testing::sampled;
using testing::sliders;
using testing::tribometer;

double x_of(const Instant& instant, std::size_t body) {
  return instant.bodies[body].pose.p_WL.x();
}

// First slip: asin(Fs/((k − m w²) a))/w. The others by the pieces' closed
// forms. Tribometer of [Perechesova2014].
TEST(Friction, TribometerSticksAndSlipsAtTheKnownTimes) {
  const Motion motion = simulate(tribometer({.breakaway = 4.5, .kinetic = 3.0}),
                                 sampled(3.0, 301, 1e-9));
  const double w = 2.0 * M_PI;
  const double first = std::asin(4.5 / ((1000.0 - 0.5 * w * w) * 0.010)) / w;
  ASSERT_GE(motion.events.size(), 23u);
  EXPECT_NEAR(motion.events[0].t, first, 1e-9);
  const double known[] = {0.075907, 0.168777, 0.448316, 0.551973,
                          0.607845, 0.696681, 0.935814, 1.040140};
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_NEAR(motion.events[i].t, known[i], 6e-7);
    EXPECT_EQ(motion.events[i].what, i % 2 == 0 ? "slip" : "stick");
  }
  EXPECT_EQ(motion.events.size(), 23u);
  EXPECT_LT(motion.integration->relative_energy_error, 1e-7);
}

// A mass that a spring pulls over a belt of constant speed.
TEST(Friction, BeltOfConstantSpeedHasThePeriodOfTheClosedForm) {
  MechanismDefinition m = tribometer({.breakaway = 4.5, .kinetic = 3.0});
  m.drives[0].law = DriveLaw::kRamp;
  m.drives[0].to = 0.04;
  m.drives[0].duration = 2.0;  // 20 mm/s
  m.initial_joints[0].rate = 0.020;
  const Motion motion = simulate(m, sampled(2.0, 201, 1e-9));
  const double kv = 1000.0 * 0.020, wn = std::sqrt(1000.0 / 0.5);
  const double stick = 2.0 * 1.5 / kv;
  const double slip = 2.0 / wn * (M_PI - std::atan(1.5 * wn / kv));
  ASSERT_GE(motion.events.size(), 7u);
  for (std::size_t i = 0; i + 1 < 7; ++i) {
    EXPECT_NEAR(motion.events[i + 1].t - motion.events[i].t,
                motion.events[i].what == "slip" ? slip : stick, 1e-8);
  }
}

TEST(Friction, CoulombStickSlip) {
  const Motion motion = simulate(pulled({.breakaway = 1.5, .kinetic = 1.0}),
                                 sampled(25.0, 251, 1e-9));
  ASSERT_GE(motion.events.size(), 4u);
  EXPECT_NEAR(motion.events[0].t, 7.5, 1e-8);
  EXPECT_NEAR(motion.events[1].t - motion.events[0].t, 2.611259254101, 1e-8);
  EXPECT_NEAR(motion.events[2].t - motion.events[1].t, 5.0, 1e-8);
}

TEST(Friction, LuGre) {
  const Motion motion =
      simulate(pulled(testing::bristles()), sampled(25.0, 26, 1e-7));
  EXPECT_NEAR(x_of(motion.instants.back(), 1), 1.908839199, 1e-6);
}

// The speed falls by the closed form and ends in true rest; or creeps.
TEST(Friction, ViscousAndRegularizedSlowAFlywheel) {
  MechanismDefinition m = flywheel(0.5);
  m.elements = {on_joint(
      0, FrictionLaw{.breakaway = 2.0, .kinetic = 2.0, .viscous = 1.0})};
  m.initial_joints = {
      {.joint = 0, .position = {}, .rate = 4.0, .place = "initial"}};
  const Motion motion = simulate(m, sampled(1.0, 11, 1e-9));
  // 0.5 w' = -2 - w
  const double rest = 0.5 * std::log(3.0);
  for (const Instant& i : motion.instants) {
    EXPECT_NEAR(i.bodies[0].w_WL.z(),
                i.t < rest ? 6.0 * std::exp(-2.0 * i.t) - 2.0 : 0.0, 1e-8);
  }
  ASSERT_EQ(motion.events.size(), 1u);
  EXPECT_NEAR(motion.events[0].t, rest, 1e-9);
  EXPECT_EQ(motion.events[0].what, "stick");

  // I w' = −F tanh(w/v): sinh(w/v) = sinh(w₀/v) exp(−F t/(I v))
  m.elements = {on_joint(0, FrictionLaw{.model = FrictionModel::kRegularized,
                                        .breakaway = 2.0,
                                        .kinetic = 2.0,
                                        .regularizing_speed = 0.5})};
  const Motion creeps = simulate(m, sampled(1.5, 16, 1e-9));
  for (const Instant& i : creeps.instants) {
    EXPECT_NEAR(
        i.bodies[0].w_WL.z(),
        0.5 * std::asinh(std::sinh(4.0 / 0.5) * std::exp(-2.0 * i.t / 0.25)),
        1e-8);
  }
}

// Energy that slides into friction: v dv/dx = −F(v)/m with F falling to the
// kinetic one, so distance = ∫ m v/F(v) dv.
TEST(Friction, StribeckStopsASliderWhereTheIntegralSays) {
  MechanismDefinition m = sliders({2.0});
  const FrictionLaw law{
      .breakaway = 3.0, .kinetic = 1.0, .viscous = 0.5, .stribeck_speed = 0.2};
  m.elements = {on_joint(0, law)};
  m.initial_joints = {
      {.joint = 0, .position = {}, .rate = 1.0, .place = "initial"}};
  const Motion motion = simulate(m, sampled(3.0, 4, 1e-9));
  double distance = 0.0;
  constexpr int kParts = 20000;  // Simpson
  for (int i = 0; i <= kParts; ++i) {
    const double v = static_cast<double>(i) / kParts;
    const double r = v / 0.2;
    const double force = 1.0 + 2.0 * std::exp(-r * r) + 0.5 * v;
    const double weight = i == 0 || i == kParts ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    distance += weight * 2.0 * v / force / (3.0 * kParts);
  }
  EXPECT_NEAR(x_of(motion.instants.back(), 0), distance, 1e-8);
  EXPECT_EQ(motion.events.size(), 1u);
}

// Two frictions on one guide act like one with their sum.
TEST(Friction, OfOneFreedomAddsUp) {
  MechanismDefinition m = pulled({.breakaway = 0.9, .kinetic = 0.4});
  m.elements.push_back(
      on_joint(1, FrictionLaw{.breakaway = 0.6, .kinetic = 0.6}));
  const Motion motion = simulate(m, sampled(25.0, 251, 1e-9));
  ASSERT_EQ(motion.events.size(), 10u);  // both at once
  const double slip = 2.611259254101;
  const double known[] = {7.5, 7.5 + slip, 12.5 + slip, 12.5 + 2.0 * slip};
  for (std::size_t k = 0; k < 8; ++k) {
    EXPECT_NEAR(motion.events[k].t, known[k / 2], 1e-8);
    EXPECT_EQ(motion.events[k].what, k / 2 % 2 == 0 ? "slip" : "stick");
  }
  EXPECT_LT(motion.integration->relative_energy_error, 1e-9);
}

// 4 N on two times 3 N: how the lines share it is open, that they hold is not.
TEST(Friction, OfOneFreedomIsNotUniqueAtRest) {
  MechanismDefinition m = sliders({1.0});
  const auto friction =
      on_joint(0, FrictionLaw{.breakaway = 3.0, .kinetic = 2.0});
  m.elements = {
      on_joint(0, TableLaw{.times = {0.0, 10.0}, .efforts = {4.0, 14.0}}),
      friction, friction};
  const Motion motion = simulate(m, sampled(4.0, 5, 1e-9));
  const Instant& rests = motion.instants[1];
  EXPECT_NEAR(rests.elements[1].effort + rests.elements[2].effort, -5.0, 1e-9);
  EXPECT_TRUE(rests.elements[0].unique);
  EXPECT_FALSE(rests.elements[1].unique);
  EXPECT_FALSE(rests.elements[2].unique);
  const Instant& slips = motion.instants[3];
  EXPECT_TRUE(slips.elements[1].unique);
  EXPECT_TRUE(slips.elements[2].unique);
  m.elements.pop_back();
  m.elements[0] = on_joint(0, TableLaw{.times = {0.0}, .efforts = {2.5}});
  EXPECT_TRUE(
      simulate(m, sampled(4.0, 5, 1e-9)).instants[4].elements[1].unique);
}

// Two flywheels geared 1 : −2 under a torque that grows by 1 N m/s: they move
// when it exceeds F₁ + F₂/2, then with I₁ + I₂/4 against K₁ + K₂/2.
TEST(Friction, OfGearedFlywheelsActsThroughTheRatio) {
  MechanismDefinition m = flywheel(0.5);
  m.bodies.push_back(m.bodies[0]);
  m.joints.push_back(m.joints[0]);
  m.joints[1].body_b = 1;
  m.couplings = {{.name = "gear",
                  .joint_1 = 0,
                  .coordinate_1 = 0,
                  .joint_2 = 1,
                  .coordinate_2 = 0,
                  .ratio = -2.0,
                  .offset = {},
                  .place = "coupling"}};
  m.elements = {
      on_joint(0, TableLaw{.times = {0.0, 10.0}, .efforts = {0.0, 10.0}}),
      on_joint(0, FrictionLaw{.breakaway = 1.0, .kinetic = 0.5}),
      on_joint(1, FrictionLaw{.breakaway = 3.0, .kinetic = 2.0})};
  const Motion motion = simulate(m, sampled(4.0, 5, 1e-9));
  ASSERT_EQ(motion.events.size(), 2u);
  EXPECT_NEAR(motion.events[0].t, 2.5, 1e-9);
  EXPECT_NEAR(motion.events[1].t, 2.5, 1e-9);
  EXPECT_LT(motion.integration->steps, 100);
  const double left = (0.5 * (16.0 - 6.25) - 1.5 * 1.5) / 0.625;
  EXPECT_NEAR(motion.instants.back().bodies[0].w_WL.z(), left, 1e-8);
  EXPECT_NEAR(motion.instants.back().bodies[1].w_WL.z(), -0.5 * left, 1e-8);
  for (const Instant& i : motion.instants) {  // never more than it can give
    EXPECT_LE(std::abs(i.elements[1].effort), 1.0 + 1e-9);
    EXPECT_LE(std::abs(i.elements[2].effort), 3.0 + 1e-9);
  }
}

// Friction in all four joints of a four-bar: it swings, stops for good, and
// what the joints lost is what the bars fell.
TEST(Friction, FourBarWithFrictionInAllJointsComesToRest) {
  MechanismDefinition m = testing::two_window_four_bar();
  m.bodies.erase(m.bodies.begin() + 4);
  m.bodies.erase(m.bodies.begin() + 2);
  m.joints = {testing::pin("A0", kGround, 0, 0.0, 0.0),
              testing::pin("A1", kGround, 1, 1.0, 0.0),
              testing::pin("B0", 0, 2, 1.0, 0.0),
              testing::pin("B1", 1, 2, 1.0, 1.0)};
  for (std::size_t i = 0; i < 2; ++i) {  // off the change point, hanging
    m.bodies[i].placement.R_WL = testing::turned(-2.2);
  }
  m.bodies[2].placement.p_WL = m.bodies[0].placement.R_WL.col(0);
  m.initial_joints.clear();
  for (int joint = 0; joint < 4; ++joint) {
    m.elements.push_back(
        on_joint(joint, FrictionLaw{.breakaway = 0.9, .kinetic = 0.6}));
  }
  const Motion motion = simulate(m, sampled(10.0, 101, 1e-8));
  const Instant& end = motion.instants.back();
  EXPECT_LT(end.bodies[0].w_WL.norm(), 1e-20);
  double lost = 0.0;
  for (std::size_t k = 1; k < motion.instants.size(); ++k) {
    const auto angle = [&](std::size_t i) {
      return motion.instants[i].elements[0].position;
    };
    // between instants it may turn: a bound only, met where it does not
    lost += 4.0 * 0.6 * std::abs(angle(k) - angle(k - 1));
  }
  double fallen = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto height = [&](const Instant& at) {
      const Pose& pose = at.bodies[i].pose;
      return (pose.p_WL + 0.5 * pose.R_WL.col(0)).y();
    };
    fallen += 9.81 * (height(motion.instants.front()) - height(end));
  }
  EXPECT_LT(lost, fallen + 1e-9);
  EXPECT_GT(lost, 0.99 * fallen);
  EXPECT_LT(motion.integration->relative_energy_error, 1e-7);
}

}  // namespace
}  // namespace clevis::mechanism
