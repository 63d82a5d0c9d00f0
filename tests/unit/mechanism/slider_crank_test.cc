#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mechanism/simulate.h"
#include "support/four_bar.h"

namespace clevis::mechanism {
namespace {

using namespace testing;

constexpr double kCrank = 0.05, kRod = 0.16, kOffset = 0.02, kSlider = 0.4;

/// Crank at the origin, slider on y = offset along x, its mass alone counts
/// (crank and rod weigh next to nothing).
MechanismDefinition slider_crank(double light) {
  MechanismDefinition m;
  const auto body = [&m](const char* name, const Vector3d& p, double angle,
                         double mass) {
    BodyDefinition b;
    b.name = name;
    b.placement = {.p_WL = p, .R_WL = turned(angle)};
    b.mass_properties = bar(mass, 0.0, 0.0, 1e-3 * mass);
    m.bodies.push_back(b);
  };
  const double phi = 0.4;
  const Vector3d pin = kCrank * Vector3d(std::cos(phi), std::sin(phi), 0.0);
  const double psi = std::asin((kOffset - pin.y()) / kRod);
  body("crank", Vector3d::Zero(), phi, light);
  body("rod", pin, psi, light);
  body("slider", {pin.x() + kRod * std::cos(psi), kOffset, 0.0}, 0.0, kSlider);
  const auto joint = [&m](const char* name, JointType type, int a, int b,
                          const JointFrame& fa, const JointFrame& fb) {
    m.joints.push_back({.name = name,
                        .type = type,
                        .body_a = a,
                        .body_b = b,
                        .frame_a = fa,
                        .frame_b = fb,
                        .place = name});
  };
  JointFrame guide = slide(1.0);
  guide.p_LJ = {0.0, kOffset, 0.0};
  joint("O", JointType::kRevolute, kGround, 0, at(0, 0), at(0, 0));
  joint("P", JointType::kRevolute, 0, 1, at(kCrank, 0), at(0, 0));
  joint("Q", JointType::kRevolute, 1, 2, at(kRod, 0), at(0, 0));
  joint("guide", JointType::kPrismatic, kGround, 2, guide, slide(1.0));
  DriveDefinition drive;
  drive.joint = 0;
  drive.law = DriveLaw::kRamp;
  drive.from = phi;
  drive.to = phi + 2.0 * std::numbers::pi;
  drive.duration = 0.1;
  m.drives.push_back(drive);
  return m;
}

struct SliderMotion {
  double x{}, v{}, a{}, psi{};
};

/// x = r cos φ + √(l² − (e − r sin φ)²) and its derivatives.
SliderMotion closed_form(double phi, double w) {
  const double s = kOffset - kCrank * std::sin(phi);
  const double s1 = -kCrank * w * std::cos(phi);
  const double s2 = kCrank * w * w * std::sin(phi);
  const double root = std::sqrt(kRod * kRod - s * s);
  const double root1 = -s * s1 / root;
  const double root2 = -(s1 * s1 + s * s2 + root1 * root1) / root;
  return {.x = kCrank * std::cos(phi) + root,
          .v = -kCrank * w * std::sin(phi) + root1,
          .a = -kCrank * w * w * std::cos(phi) + root2,
          .psi = std::asin(s / kRod)};
}

TEST(SliderCrank, PositionVelocityAcceleration) {
  const Motion motion =
      simulate(slider_crank(1e-9), {.duration = 0.1, .instants = 91});
  for (const Instant& at : motion.instants) {
    const double w = at.drives[0].rate;
    const SliderMotion expected = closed_form(at.drives[0].position, w);
    const BodyState& slider = at.bodies[2];
    EXPECT_NEAR(slider.pose.p_WL.x(), expected.x, 1e-13);
    EXPECT_NEAR(slider.v_WLo.x(), expected.v, 1e-12 * w);
    EXPECT_NEAR(slider.a_WLo.x(), expected.a, 1e-12 * w * w);
    EXPECT_NEAR(slider.pose.p_WL.y(), kOffset, 1e-13);
  }
}

// Without rod mass the rod carries m a / cos ψ along itself, the guide the
// part across, and the crank's torque is m a v / ω.
TEST(SliderCrank, ForcesOfTheSliderMass) {
  const Motion motion =
      simulate(slider_crank(1e-12), {.duration = 0.1, .instants = 91});
  for (const Instant& at : motion.instants) {
    const double w = at.drives[0].rate;
    const SliderMotion s = closed_form(at.drives[0].position, w);
    const double scale = kSlider * kCrank * w * w;
    EXPECT_NEAR(at.joints[2].f_W.x(), kSlider * s.a, 1e-9 * scale);
    EXPECT_NEAR(at.joints[2].f_W.y(), kSlider * s.a * std::tan(s.psi),
                1e-9 * scale);
    EXPECT_NEAR(at.joints[3].f_W.y(), -kSlider * s.a * std::tan(s.psi),
                1e-9 * scale);
    EXPECT_NEAR(at.drives[0].effort, kSlider * s.a * s.v / w,
                1e-9 * scale * kCrank);
  }
}

}  // namespace
}  // namespace clevis::mechanism
