#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "base/errors.h"
#include "mechanism/simulate.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

using Eigen::Vector3d;
using testing::against_a_wall;
using testing::on_joint;
using testing::pulled;
using testing::sliders;
using testing::tribometer;

SimulationSettings settings(double duration, int instants, double tolerance) {
  SimulationSettings s;
  s.duration = duration;
  s.instants = instants;
  s.tolerance = tolerance;
  return s;
}

/// A flywheel about the world's z, `inertia` about it.
MechanismDefinition flywheel(double inertia) {
  MechanismDefinition m;
  BodyDefinition wheel =
      testing::uniform_bar("wheel", Vector3d::Zero(), 0.0, 0.1);
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

double x_of(const Instant& instant, std::size_t body) {
  return instant.bodies[body].pose.p_WL.x();
}

// First slip: asin(Fs/((k − m w²) a))/w. The others by the pieces' closed
// forms, SEEDS S10 §6.
TEST(Friction, TribometerSticksAndSlipsAtTheKnownTimes) {
  const Motion motion = simulate(tribometer({.breakaway = 4.5, .kinetic = 3.0}),
                                 settings(3.0, 301, 1e-9));
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
  const Motion motion = simulate(m, settings(2.0, 201, 1e-9));
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
                                 settings(25.0, 251, 1e-9));
  ASSERT_GE(motion.events.size(), 4u);
  EXPECT_NEAR(motion.events[0].t, 7.5, 1e-8);
  EXPECT_NEAR(motion.events[1].t - motion.events[0].t, 2.611259254101, 1e-8);
  EXPECT_NEAR(motion.events[2].t - motion.events[1].t, 5.0, 1e-8);
}

TEST(Friction, LuGre) {
  const Motion motion =
      simulate(pulled(testing::bristles()), settings(25.0, 26, 1e-7));
  EXPECT_NEAR(x_of(motion.instants.back(), 1), 1.908839199, 1e-6);
}

// Linear spring and damper during contact: e = exp(−πz/√(1−z²)) if it may
// pull, exp(−2z/√(1−z²) atan(√(1−z²)/z)) if it lets go at zero force. The
// outer spring of 100 N/m, left out there, is beside 1e5 N/m.
TEST(Contact, MassAgainstAWall) {
  for (const auto model : {ContactModel::kPublished, ContactModel::kPenalty}) {
    const ContactLaw law{.model = model, .stiffness = 1e5, .damping = 20.0};
    auto m = against_a_wall(law);
    const Motion motion = simulate(m, settings(0.5, 5001, 1e-9));
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
  const Motion motion = simulate(m, settings(3.0, 31, 1e-8));
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
  const Motion motion = simulate(m, settings(1.0, 101, 1e-7));
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

// Spring and damper between two points: a mass that swings about the end.
TEST(Spring, ConservesEnergyAndRingsAtItsFrequency) {
  MechanismDefinition m = sliders({2.0});
  LineElement spring;
  spring.line.kind = ElementLine::Kind::kDistance;
  spring.line.a.p_L = {-0.5, 0.0, 0.0};
  spring.line.b.body = 0;
  spring.law = SpringLaw{.stiffness = 200.0, .damping = 4.0, .free = 0.5};
  m.elements = {spring};
  m.initial_joints = {
      {.joint = 0, .position = 0.1, .rate = {}, .place = "initial"}};
  const Motion motion = simulate(m, settings(2.0, 21, 1e-9));
  const double decay = 1.0, w = std::sqrt(100.0 - 1.0);
  for (const Instant& i : motion.instants) {
    EXPECT_NEAR(x_of(i, 0),
                0.1 * std::exp(-decay * i.t) *
                    (std::cos(w * i.t) + decay / w * std::sin(w * i.t)),
                1e-9);
    EXPECT_LT(i.power_balance_error, 1e-12);
  }
}

// In a driven motion the elements load drive and joints.
TEST(Spring, LoadsTheDriveOfADrivenMotion) {
  MechanismDefinition m = sliders({2.0});
  m.elements.push_back(on_joint(
      0, SpringLaw{.stiffness = 100.0, .damping = 3.0, .preload = 1.0}));
  m.elements.push_back(
      on_joint(0, FrictionLaw{.breakaway = 2.0, .kinetic = 1.5}));
  DriveDefinition drive;
  drive.law = DriveLaw::kSine;
  drive.amplitude = 0.1;
  drive.frequency = 1.0;
  m.drives = {drive};
  const Motion motion = simulate(m, settings(1.0, 17, 1e-9));
  EXPECT_FALSE(motion.integration);
  for (const Instant& i : motion.instants) {
    const auto& d = i.drives[0];
    const double friction = d.rate > 0.0 ? 1.5 : -1.5;
    EXPECT_NEAR(d.effort,
                2.0 * d.acceleration + 100.0 * d.position + 3.0 * d.rate + 1.0 +
                    friction,
                1e-10);
    EXPECT_LT(i.power_balance_error, 1e-12);
  }
}

// Angles count beyond a turn: 0.5 kg m² on 2 N m/rad, from 10 rad.
TEST(Spring, TorsionCountsTurns) {
  for (const auto dimension :
       {SpaceDimension::kPlanar, SpaceDimension::kSpatial}) {
    MechanismDefinition m = flywheel(0.5);
    m.dimension = dimension;
    m.elements = {
        on_joint(0, SpringLaw{.stiffness = 2.0, .free = 1.0, .preload = 3.0})};
    m.initial_joints = {
        {.joint = 0, .position = 10.0, .rate = {}, .place = "initial"}};
    const Motion motion = simulate(m, settings(5.0, 51, 1e-9));
    const double rest = 1.0 - 3.0 / 2.0;
    for (const Instant& i : motion.instants) {
      EXPECT_NEAR(i.elements[0].position,
                  rest + (10.0 - rest) * std::cos(2.0 * i.t), 1e-7);
    }
  }
}

// Torque linear in time between the table's points, constant outside: exact
// at any tolerance where steps end at the bends.
TEST(Table, TurnsAFlywheel) {
  MechanismDefinition m = flywheel(0.5);
  m.elements = {
      on_joint(0, TableLaw{.times = {0.5, 1.5}, .efforts = {1.0, 3.0}})};
  const Motion motion = simulate(m, settings(2.0, 5, 1e-4));
  // speed: 0.5 s at 2 rad/s², 1 s at 4 on average, 0.5 s at 6
  EXPECT_NEAR(motion.instants[4].bodies[0].w_WL.z(), 8.0, 1e-12);
  EXPECT_NEAR(motion.instants[4].elements[0].position,
              0.25 + (1.0 + 1.0 + 4.0 / 6.0) + (0.5 * 5.0 + 3.0 * 0.25), 1e-11);
}

// The speed falls by the closed form and ends in true rest; or creeps.
TEST(Friction, ViscousAndRegularizedSlowAFlywheel) {
  MechanismDefinition m = flywheel(0.5);
  m.elements = {on_joint(
      0, FrictionLaw{.breakaway = 2.0, .kinetic = 2.0, .viscous = 1.0})};
  m.initial_joints = {
      {.joint = 0, .position = {}, .rate = 4.0, .place = "initial"}};
  const Motion motion = simulate(m, settings(1.0, 11, 1e-9));
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
  const Motion creeps = simulate(m, settings(1.5, 16, 1e-9));
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
  const Motion motion = simulate(m, settings(3.0, 4, 1e-9));
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
  const Motion motion = simulate(m, settings(25.0, 251, 1e-9));
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
  const Motion motion = simulate(m, settings(4.0, 5, 1e-9));
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
      simulate(m, settings(4.0, 5, 1e-9)).instants[4].elements[1].unique);
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
  const Motion motion = simulate(m, settings(4.0, 5, 1e-9));
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
  const Motion motion = simulate(m, settings(10.0, 101, 1e-8));
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
    const Motion motion = simulate(m, settings(0.2, 21, 1e-10));
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

// Both ends of a stop: elastic bounces between walls 0.2 m apart.
TEST(Stop, BouncesBetweenBothEnds) {
  MechanismDefinition m = sliders({1.0});
  m.elements = {on_joint(
      0, StopLaw{.lower = -0.1, .upper = 0.1, .contact = {.stiffness = 1e6}})};
  m.initial_joints = {
      {.joint = 0, .position = 0.0, .rate = 1.0, .place = "initial"}};
  const Motion motion = simulate(m, settings(1.0, 11, 1e-9));
  const double inside = M_PI / 1e3;  // half a period of 1 kg on 1e6 N/m
  ASSERT_EQ(motion.events.size(), 10u);
  for (std::size_t k = 0; k < 10; ++k) {
    const auto bounce = static_cast<double>(k / 2);
    EXPECT_NEAR(motion.events[k].t,
                0.1 + bounce * (0.2 + inside) + (k % 2 == 1 ? inside : 0.0),
                1e-10);
    EXPECT_EQ(motion.events[k].what, k % 2 == 0 ? "press" : "release");
  }
}

/// A free body of 2 kg.
MechanismDefinition free_body() {
  MechanismDefinition m;
  BodyDefinition body = testing::uniform_bar("body", {0.1, 0.2, 0.3}, 0.0, 0.1);
  body.mass_properties.mass = 2.0;
  body.mass_properties.p_LCm.setZero();
  m.bodies = {body};
  return m;
}

// x'' + 2 D w (x' − v₀) + w² (x − x₀) = 0 about a target that moves evenly
// (natural ends: the spline is the straight line), and with absolute damping.
TEST(Impedance, FollowsAMovingTarget) {
  for (const bool absolute : {false, true}) {
    MechanismDefinition m = free_body();
    ImpedanceElement impedance;
    impedance.point.body = 0;
    const Vector3d start(0.1, 0.2, 0.3), speed(0.2, -0.1, 0.3);
    for (int k = 0; k < 3; ++k) {
      impedance.path_W[static_cast<std::size_t>(k)] =
          numerics::interpolating_spline({0.0, 1.0},
                                         {start[k], start[k] + speed[k]},
                                         numerics::SplineEnds::kNatural);
    }
    impedance.stiffness = 200.0;
    impedance.damping = 8.0;
    impedance.damps_absolute = absolute;
    m.elements = {impedance};
    const Motion motion = simulate(m, settings(1.0, 11, 1e-10));
    const double decay = 2.0, w = std::sqrt(100.0 - 4.0);
    // what the target's speed makes the body lag behind in the end
    const double lag = absolute ? 8.0 / 200.0 : 0.0;
    for (const Instant& i : motion.instants) {
      const double e = std::exp(-decay * i.t), c = std::cos(w * i.t),
                   s = std::sin(w * i.t);
      // x − x₀ = −v₀ (lag − e^(−d t)(lag cos − (1 − d lag)/w sin)) by x(0),
      // x'(0)
      const double off = -lag + e * (lag * c + (decay * lag - 1.0) / w * s);
      const Vector3d x = start + speed * (i.t + off);
      EXPECT_LT((i.bodies[0].pose.p_WL - x).norm(), 1e-9);
    }
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
  const Motion motion = simulate(m, settings(0.5, 6, 1e-7));
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
