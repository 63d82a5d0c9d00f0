// Joint friction proportional to the joint's own reaction.
#include <cmath>

#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "mechanism/element_base/acting_element.h"
#include "mechanism/simulate.h"
#include "support/four_bar.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

using Eigen::Vector3d;
using testing::on_joint;

constexpr double kG = 9.81;

SimulationSettings settings(double duration, int instants) {
  SimulationSettings s;
  s.duration = duration;
  s.instants = instants;
  s.tolerance = 1e-9;
  return s;
}

/// @param arm  1 where the joint slides, else the radius of its pin [m].
FrictionLaw following(double kinetic, double at_rest, double arm = 1.0) {
  FrictionLaw law;
  law.kinetic = kinetic * arm;
  law.breakaway = at_rest * arm;
  law.follows_reaction = true;
  return law;
}

std::string code_of(const MechanismDefinition& m) {
  try {
    simulate(m, settings(1.0, 11));
  } catch (const Error& error) {
    return std::string(error.code());
  }
  return "";
}

/// 2 kg that slide along x, down a slope if gravity leans by its angle;
/// `sideways` turns the rest of gravity out of the plane.
MechanismDefinition on_a_slope(double angle, double sideways,
                               const FrictionLaw& law) {
  MechanismDefinition m = testing::sliders({2.0});
  m.gravity_W =
      kG * Vector3d(std::sin(angle), -std::cos(angle) * std::cos(sideways),
                    std::cos(angle) * std::sin(sideways));
  m.elements = {on_joint(0, law)};
  return m;
}

TEST(JointFriction, SlideOnASlope) {
  constexpr double angle = M_PI / 6.0, mu = 0.2;
  const double a = kG * (std::sin(angle) - mu * std::cos(angle));
  FrictionLaw tanh = following(mu, mu);
  tanh.model = FrictionModel::kRegularized;
  tanh.regularizing_speed = 1e-9;
  for (const FrictionLaw& law : {following(mu, 0.3), tanh}) {
    for (const double sideways : {0.0, 0.7}) {
      const Motion motion =
          simulate(on_a_slope(angle, sideways, law), settings(1.0, 11));
      const Instant& end = motion.instants.back();
      EXPECT_NEAR(end.bodies[0].pose.p_WL.x(), 0.5 * a, 1e-8);
      EXPECT_NEAR(end.elements[0].effort, -mu * 2.0 * kG * std::cos(angle),
                  1e-8);
      EXPECT_LT(motion.integration->relative_energy_error, 1e-8);
      EXPECT_LT(motion.integration->evaluations, 20000);
    }
  }
}

TEST(JointFriction, SlideRestsWhereTheSlopeIsGentle) {
  constexpr double angle = M_PI / 12.0;  // tan 15° = 0.268
  const Motion rests =
      simulate(on_a_slope(angle, 0.0, following(0.2, 0.27)), settings(1.0, 3));
  EXPECT_NEAR(rests.instants[2].bodies[0].pose.p_WL.x(), 0.0, 1e-12);
  EXPECT_NEAR(rests.instants[2].elements[0].effort, -2.0 * kG * std::sin(angle),
              1e-9);
  const Motion slips =
      simulate(on_a_slope(angle, 0.0, following(0.2, 0.26)), settings(1.0, 3));
  EXPECT_NEAR(slips.instants[2].bodies[0].pose.p_WL.x(),
              0.5 * kG * (std::sin(angle) - 0.2 * std::cos(angle)), 1e-8);
}

/// The drive of slide 0 pushes it on by 0.3 m in 1 s.
DriveDefinition pushing() {
  DriveDefinition drive;
  drive.law = DriveLaw::kQuintic;
  drive.to = 0.3;
  drive.duration = 1.0;
  return drive;
}

TEST(JointFriction, DriveOfASlidePaysForIt) {
  constexpr double angle = 0.5, mu = 0.15;
  MechanismDefinition m = on_a_slope(angle, 0.0, following(mu, mu));
  m.drives = {pushing()};
  const Motion motion = simulate(m, settings(1.0, 11));
  ASSERT_FALSE(motion.integration);
  for (int i = 1; i < 10; ++i) {
    const Instant& at = motion.instants[static_cast<std::size_t>(i)];
    const double needed =
        2.0 * (at.drives[0].acceleration - kG * std::sin(angle) +
               mu * kG * std::cos(angle));
    EXPECT_NEAR(at.drives[0].effort, needed, 1e-9);
    EXPECT_LT(at.power_balance_error, 1e-12);
  }
}

/// The same on a level guide, with its mass centre so far ahead of its point J
/// along the slide.
MechanismDefinition overhung(double ahead, const FrictionLaw& law) {
  MechanismDefinition m = on_a_slope(0.0, 0.0, law);
  m.bodies[0].mass_properties.p_LCm.x() = ahead;
  return m;
}

FrictionLaw guided(double mu, const Guide& guide) {
  FrictionLaw law = following(mu, mu);
  law.guide = guide;
  return law;
}

// Both ends of a guide of length L press where the weight hangs e before its
// middle: with m g as long as e < L/2, else with 2 m g e/L together. The middle
// moves with the slider, or stays where the ground's point J is.
TEST(JointFriction, EndsOfAGuidePressByTheMomentToo) {
  constexpr double mu = 0.15, length = 0.2, weight = 2.0 * kG;
  for (const double ahead : {0.05, 0.25, -0.25}) {
    for (const bool is_on_slider : {true, false}) {
      const FrictionLaw law = guided(mu, {length, is_on_slider});
      MechanismDefinition m = overhung(ahead, law);
      m.drives = {pushing()};
      for (const Instant& at : simulate(m, settings(1.0, 11)).instants) {
        if (!(at.drives[0].rate > 0.0)) continue;
        const double arm = ahead + (is_on_slider ? 0.0 : at.drives[0].position);
        const double pressing =
            weight * std::max(1.0, 2.0 * std::abs(arm) / length);
        EXPECT_NEAR(at.drives[0].effort,
                    2.0 * at.drives[0].acceleration + mu * pressing, 1e-9);
      }
    }
  }
}

// Thrown along, it comes to rest after v²/(2 μ g) by the force alone and in
// L/(2 e) of that by the ends.
TEST(JointFriction, OverhungSliderThatIsThrownRestsSooner) {
  constexpr double mu = 0.15, speed = 1.0, ahead = 0.25, length = 0.2;
  MechanismDefinition m = overhung(ahead, guided(mu, {length, true}));
  m.initial_joints = {
      {.joint = 0, .position = {}, .rate = speed, .place = "initial"}};
  const Motion motion = simulate(m, settings(1.0, 11));
  EXPECT_NEAR(motion.instants.back().bodies[0].pose.p_WL.x(),
              0.5 * speed * speed / (mu * kG) * length / (2.0 * ahead), 1e-8);
  EXPECT_LT(motion.integration->relative_energy_error, 1e-8);
}

// 12 N along x act on B, 1 kg, which comes to rest on a rail at 45° of A, 2 kg.
// Friction of A along x breaks away at 9 N, of B along y at 10 N: both lines
// are asked for more at the same time, and accelerate while they give their
// most. Then they have 2 and 1 N: a_A = 1.8 m/s², whichever is named first.
TEST(JointFriction, LinesThatBreakAwayAtOnceSlipTogether) {
  MechanismDefinition m = testing::sliders({2.0});
  m.gravity_W.setZero();
  m.bodies.push_back(m.bodies[0]);
  m.bodies[1].name = "B";
  m.bodies[1].mass_properties.mass = 1.0;
  JointFrame rail;
  rail.R_LJ = with_z_along(Vector3d(1.0, 1.0, 0.0).normalized());
  m.joints.push_back({.name = "rail",
                      .type = JointType::kPrismatic,
                      .body_a = 0,
                      .body_b = 1,
                      .frame_a = rail,
                      .frame_b = rail,
                      .place = "joint"});
  m.initial_joints = {
      {.joint = 0, .position = {}, .rate = 0.0, .place = "initial"},
      {.joint = 1, .position = {}, .rate = -1.0, .place = "initial"}};
  ConstantForce push;
  push.point.body = 1;
  push.f_W = {12.0, 0.0, 0.0};
  LineElement of_a = on_joint(0, FrictionLaw{.breakaway = 9.0, .kinetic = 2.0});
  LineElement of_b = of_a;
  of_b.law = FrictionLaw{.breakaway = 10.0, .kinetic = 1.0};
  of_b.line = {.kind = ElementLine::Kind::kSlide, .axis_L = Vector3d::UnitY()};
  of_b.line.a.body = kGround;
  of_b.line.b.body = 1;
  const double slips = 0.6 - std::sqrt(2.0) / 13.0;
  using Elements = std::vector<ForceElement>;
  for (const Elements& elements :
       {Elements{push, of_a, of_b}, Elements{of_b, of_a, push}}) {
    m.elements = elements;
    const Motion motion = simulate(m, settings(0.6, 3));
    EXPECT_NEAR(motion.instants.back().bodies[0].pose.p_WL.x(),
                0.9 * slips * slips, 1e-7);
  }
}

/// A force along the slide that acts so far beside it.
MechanismDefinition pushed_aside(double beside, double mu, double length) {
  MechanismDefinition m = overhung(0.0, guided(mu, {length, true}));
  m.gravity_W.setZero();
  ConstantForce push;
  push.name = "push";
  push.point.body = 0;
  push.point.p_L = {0.0, beside, 0.0};
  push.f_W = {10.0, 0.0, 0.0};
  m.elements.push_back(push);
  return m;
}

// The push F has the ends press with 2 F h/L: of it 1 − 2 μ h/L are left, and
// nothing as soon as that is 1, however large the push.
TEST(JointFriction, DrawerJamsWhereItIsPushedFarAside) {
  constexpr double mu = 0.25, length = 0.2;
  for (const double beside : {0.1, 0.39}) {
    const Motion motion =
        simulate(pushed_aside(beside, mu, length), settings(1.0, 3));
    EXPECT_NEAR(motion.instants.back().bodies[0].pose.p_WL.x(),
                0.5 * 5.0 * (1.0 - 2.0 * mu * beside / length), 1e-8);
  }
  const Motion jammed =
      simulate(pushed_aside(0.41, mu, length), settings(1.0, 3));
  EXPECT_EQ(jammed.instants.back().bodies[0].pose.p_WL.x(), 0.0);
}

// With the mass centre z₀ beside the plane of motion a = μ √(g² + (2 a z₀/L)²)
// slows it down, of which a motion in the plane knows the first part alone.
TEST(JointFriction, GuidePressedBesideThePlaneOfMotionNeedsSpace) {
  constexpr double mu = 0.15, speed = 1.0, beside = 0.4, length = 0.2;
  MechanismDefinition m = overhung(0.0, guided(mu, {length, true}));
  m.bodies[0].mass_properties.p_LCm.z() = beside;
  m.initial_joints = {
      {.joint = 0, .position = {}, .rate = speed, .place = "initial"}};
  EXPECT_EQ(code_of(m), "K011");
  m.dimension = SpaceDimension::kSpatial;
  const double r = 2.0 * mu * beside / length;
  const double slowing = mu * kG / std::sqrt(1.0 - r * r);
  const Motion motion = simulate(m, settings(1.0, 11));
  EXPECT_NEAR(motion.instants.back().bodies[0].pose.p_WL.x(),
              0.5 * speed * speed / slowing, 1e-8);
}

/// A bar of 1 m, 1 kg on a pin at its end, without gravity, at 10 rad/s.
MechanismDefinition spinning_bar(double arm) {
  MechanismDefinition m;
  m.bodies = {testing::uniform_bar("bar", Vector3d::Zero(), 0.3, 1.0)};
  m.joints = {testing::pin("O", kGround, 0, 0.0, 0.0)};
  m.elements = {on_joint(0, following(1.0, 1.0, arm))};
  m.initial_joints = {
      {.joint = 0, .position = {}, .rate = 10.0, .place = "initial"}};
  return m;
}

// The pin holds m c √(ω⁴ + ω'²), I ω' = −μ r times that: with k = μ r m c/I,
// ω' = −κ ω², κ = k/√(1 − k²), so that ω = ω₀/(1 + κ ω₀ t).
TEST(JointFriction, JournalSlowsABarByItsOwnCentrifugalForce) {
  constexpr double arm = 0.05, k = arm * 0.5 * 3.0;
  const double kappa = k / std::sqrt(1.0 - k * k);
  const Motion motion = simulate(spinning_bar(arm), settings(2.0, 5));
  for (const Instant& at : motion.instants) {
    EXPECT_NEAR(at.bodies[0].w_WL.z(), 10.0 / (1.0 + kappa * 10.0 * at.t),
                1e-7);
    EXPECT_NEAR(at.elements[0].effort, -arm * at.joints[0].f_W.norm(), 1e-9);
    EXPECT_LT(at.power_balance_error, 1e-10);
  }
  EXPECT_LT(motion.integration->relative_energy_error, 1e-8);
}

// k > 1: friction grows faster than the inertia that asks for it
TEST(JointFriction, PinThatIsTooThickJams) {
  EXPECT_EQ(code_of(spinning_bar(0.66)), "");
  EXPECT_EQ(code_of(spinning_bar(0.67)), "K011");
}

// All four pins at once: each effort is its own joint's force times μ r.
TEST(JointFriction, FourBarWithFrictionInAllPins) {
  testing::FourBar l;
  MechanismDefinition m = testing::four_bar(l, 0.7);
  m.drives.clear();
  m.gravity_W = {0.0, -kG, 0.0};
  m.initial_joints = {
      {.joint = 0, .position = {}, .rate = 30.0, .place = "initial"}};
  std::size_t pins = 0;
  for (std::size_t j = 0; j < m.joints.size(); ++j) {
    if (m.joints[j].type != JointType::kRevolute) continue;
    m.elements.push_back(
        on_joint(static_cast<int>(j), following(0.2, 0.2, 0.005)));
    ++pins;
  }
  ASSERT_GE(pins, 3u);
  const Motion motion = simulate(m, settings(0.1, 11));
  EXPECT_LT(motion.integration->relative_energy_error, 1e-7);
  for (const Instant& at : motion.instants) {
    EXPECT_LT(at.power_balance_error, 1e-9);
    for (const ElementState& element : at.elements) {
      const auto k = static_cast<std::size_t>(&element - at.elements.data());
      const auto& line = std::get<LineElement>(m.elements[k]).line;
      const double force =
          at.joints[static_cast<std::size_t>(line.joint)].f_W.norm();
      EXPECT_NEAR(std::abs(element.effort), 0.001 * force,
                  1e-9 * (1.0 + force));
      EXPECT_LE(element.power, 0.0);
    }
  }
}

TEST(JointFriction, OfAnOpenReactionIsRefused) {
  MechanismDefinition m = spinning_bar(0.01);
  m.joints.push_back(m.joints[0]);
  m.joints[1].frame_a.p_LJ.z() = m.joints[1].frame_b.p_LJ.z() = 0.4;
  EXPECT_EQ(code_of(m), "K011");
}

}  // namespace
}  // namespace clevis::mechanism
