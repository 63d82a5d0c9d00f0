// Joint friction proportional to the joint's own reaction.
#include <cmath>

#include <gtest/gtest.h>

#include "base/messages/errors.h"
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

TEST(JointFriction, DriveOfASlidePaysForIt) {
  constexpr double angle = 0.5, mu = 0.15;
  MechanismDefinition m = on_a_slope(angle, 0.0, following(mu, mu));
  DriveDefinition drive;
  drive.law = DriveLaw::kQuintic;
  drive.to = 0.3;
  drive.duration = 1.0;
  m.drives = {drive};
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
