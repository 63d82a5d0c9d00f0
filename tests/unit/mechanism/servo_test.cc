#include <algorithm>
#include <cmath>
#include <complex>

#include <gtest/gtest.h>

#include "mechanism/simulate.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

using Eigen::Vector3d;

constexpr double kInertia = 2e-3;  // [kg m²]
constexpr double kSpeed = 2.0 * M_PI * 10.0;

ServoLaw ten_hertz(double damping_ratio) {
  ServoLaw law;
  law.stiffness = kInertia * kSpeed * kSpeed;
  law.damping = 2.0 * damping_ratio * kInertia * kSpeed;
  return law;
}

MechanismDefinition disc(const ServoLaw& law) {
  MechanismDefinition m;
  BodyDefinition body =
      testing::uniform_bar("disc", Vector3d::Zero(), 0.0, 0.1);
  body.mass_properties.p_LCm.setZero();
  body.mass_properties.inertia_LCm = kInertia * Eigen::Matrix3d::Identity();
  m.bodies = {body};
  m.joints = {testing::pin("shaft", kGround, 0, 0.0, 0.0)};
  m.elements = {testing::on_joint(0, law)};
  return m;
}

SimulationSettings settings(double duration, int instants) {
  SimulationSettings s;
  s.duration = duration;
  s.instants = instants;
  s.tolerance = 1e-10;
  return s;
}

const ElementState& servo_at(const Instant& instant) {
  return instant.elements[0];
}

// e'' + 2 ζ ω e' + ω² e = 0 from e = −0.3 at rest.
TEST(Servo, GoesToAConstantAsADampedOscillator) {
  ServoLaw law = ten_hertz(0.7);
  law.reference.law = DriveLaw::kConstant;
  law.reference.from = 0.3;
  MechanismDefinition m = disc(law);
  m.initial_joints = {
      {.joint = 0, .position = 0.0, .rate = 0.0, .place = "initial"}};
  const double decay = 0.7 * kSpeed, w = kSpeed * std::sqrt(1.0 - 0.49);
  for (const Instant& instant : simulate(m, settings(0.2, 21)).instants) {
    const double t = instant.t;
    const double left = 0.3 * std::exp(-decay * t) *
                        (std::cos(w * t) + decay / w * std::sin(w * t));
    EXPECT_NEAR(servo_at(instant).position, 0.3 - left, 1e-9);
    EXPECT_EQ(servo_at(instant).channels.at(0), 0.3);
  }
}

// A reference that accelerates by a leaves it a/ω² behind; damping acts on
// the difference of the rates, so that none of it is the speed's.
TEST(Servo, LagsBehindAnAcceleratedReferenceByItsBandwidth) {
  ServoLaw law = ten_hertz(1.0);
  law.reference.law = DriveLaw::kSine;
  law.reference.amplitude = 0.5;
  law.reference.frequency = 0.25;
  const Motion motion = simulate(disc(law), settings(3.0, 301));
  const double drive = 2.0 * M_PI * 0.25;
  // transfer (2 ω s + ω²)/(s + ω)² less 1 at s = i drive
  const std::complex<double> s(0.0, drive);
  const std::complex<double> off = -0.5 * s * s / ((s + kSpeed) * (s + kSpeed));
  for (const Instant& instant : motion.instants) {
    if (instant.t < 1.0) continue;
    const double known = (off * std::exp(s * instant.t)).imag();
    EXPECT_NEAR(servo_at(instant).position - servo_at(instant).channels.at(0),
                known, 1e-9);
  }
  EXPECT_NEAR(std::abs(off) / (0.5 * drive * drive / kSpeed / kSpeed), 1.0,
              1e-3);
}

TEST(Servo, GivesNoMoreThanItsLimit) {
  ServoLaw law = ten_hertz(1.0);
  law.reference.law = DriveLaw::kConstant;
  law.reference.from = 3.0;
  law.limit = 0.4;
  MechanismDefinition m = disc(law);
  m.initial_joints = {
      {.joint = 0, .position = 0.0, .rate = 0.0, .place = "initial"}};
  const Motion motion = simulate(m, settings(1.5, 1501));
  double most = 0.0;
  for (const Instant& instant : motion.instants) {
    const double effort = std::abs(servo_at(instant).effort);
    EXPECT_LE(effort, 0.4);
    most = std::max(most, effort);
    if (instant.t > 0.1) continue;
    EXPECT_NEAR(servo_at(instant).position,
                0.5 * 0.4 / kInertia * instant.t * instant.t, 1e-9);
  }
  EXPECT_EQ(most, 0.4);
  EXPECT_NEAR(servo_at(motion.instants.back()).position, 3.0, 1e-6);
}

TEST(Servo, MovesASlideToo) {
  ServoLaw law;
  law.stiffness = 1e4;
  law.damping = 400.0;
  law.reference.law = DriveLaw::kQuintic;
  law.reference.to = 0.1;
  law.reference.duration = 1.0;
  MechanismDefinition m = testing::sliders({2.0});
  m.gravity_W = {-9.81, 0.0, 0.0};
  m.elements = {testing::on_joint(0, law)};
  const Motion motion = simulate(m, settings(2.0, 21));
  const ElementState& last = servo_at(motion.instants.back());
  EXPECT_NEAR(last.position, 0.1 - 2.0 * 9.81 / 1e4, 1e-9);
  EXPECT_LT(motion.integration->relative_energy_error, 1e-9);
}

}  // namespace
}  // namespace clevis::mechanism
