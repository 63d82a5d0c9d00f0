#include "beam/theory/impact.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace clevis::beam {
namespace {

constexpr double kRoundOff = 1e-13;

part::Material steel() {
  return {"steel", 210e9, 0.3, 7850.0, 355e6};
}

StruckBar rod_of_10_mm() {
  return cantilever(steel(), round_section(0.010), 0.060);
}

// π d⁴/64, π d³/32 and ρ π d² l/4 of a rod of 60 mm.
TEST(RoundSection, TenMillimetres) {
  const BarSection s = round_section(0.010);
  EXPECT_NEAR(s.second_moment, 490.9e-12, 0.05e-12);
  EXPECT_NEAR(s.section_modulus, 98.17e-9, 0.005e-9);
  EXPECT_NEAR(rod_of_10_mm().mass, 0.0370, 0.00005);
}

// Point mass on a bar without mass under a constant force: the closed motion
// satisfies m y'' = F − k y with y(0) = 0, y'(0) = V, and its largest value is
// the impact formula's.
TEST(BarImpact, IsTheLargestDeflectionOfTheMassOnTheSpring) {
  const StruckBar bar = rod_of_10_mm();
  for (const double force : {-60.0, 0.0, 8.0, 5000.0}) {
    const Blow blow{.mass = 0.2, .speed = 1.3, .force = force};
    const double w = std::sqrt(bar.stiffness / blow.mass);
    double largest = 0.0;
    constexpr int kTimes = 20000;
    for (int i = 0; i <= kTimes; ++i) {
      largest = std::max(
          largest,
          deflection_at(bar, blow, 2.0 * std::numbers::pi / w * i / kTimes));
    }
    const BarImpact found = impact(bar, blow);
    EXPECT_NEAR(largest / found.deflection, 1.0, 1e-7) << force;
    EXPECT_NEAR(found.stress / (found.deflection * bar.stiffness * 0.060 /
                                round_section(0.010).section_modulus),
                1.0, kRoundOff);
    EXPECT_EQ(found.factor.has_value(), force > 0.0);
  }
}

TEST(BarImpact, MotionObeysItsEquation) {
  const StruckBar bar = rod_of_10_mm();
  const Blow blow{.mass = 0.2, .speed = 1.3, .force = 40.0};
  const double h = 1e-6, t = 3e-4;
  const auto y = [&](double at) {
    return deflection_at(bar, blow, at);
  };
  const double acceleration = (y(t + h) - 2.0 * y(t) + y(t - h)) / (h * h);
  EXPECT_NEAR(blow.mass * acceleration + bar.stiffness * y(t), blow.force,
              1e-3 * bar.stiffness * y(t));
  EXPECT_NEAR((y(h) - y(-h)) / (2.0 * h), blow.speed, 1e-5);
}

// Without speed a force put on at once doubles the static deflection.
TEST(BarImpact, SuddenForceCountsTwice) {
  const BarImpact found =
      impact(rod_of_10_mm(), {.mass = 0.2, .speed = 0.0, .force = 100.0});
  EXPECT_NEAR(*found.factor, 2.0, kRoundOff);
}

// Reduced masses: shape functions of the static deflection, κ = ∫ w² dx / l.
TEST(StruckBar, MassPartsAreThoseOfTheStaticShape) {
  const auto integral = [](auto shape) {
    double sum = 0.0;
    constexpr int kPieces = 20000;
    for (int i = 0; i < kPieces; ++i) {
      sum += std::pow(shape((i + 0.5) / kPieces), 2) / kPieces;
    }
    return sum;
  };
  const auto s = round_section(0.01);
  EXPECT_NEAR(cantilever(steel(), s, 0.1).mass_part, integral([](double x) {
                return 0.5 * x * x * (3.0 - x);
              }),
              1e-8);
  EXPECT_NEAR(simple_beam(steel(), s, 0.1).mass_part, integral([](double x) {
                const double u = std::min(x, 1.0 - x);
                return u * (3.0 - 4.0 * u * u);
              }),
              1e-8);
  EXPECT_NEAR(rod(steel(), s, 0.1).mass_part, integral([](double x) {
                return x;
              }),
              1e-8);
}

// Rayleigh's period with the static shape: 3.5675 for Euler's 3.5160.
TEST(StruckBar, FirstPeriodIsNearEulers) {
  const StruckBar bar = rod_of_10_mm();
  const double euler = 1.875104 * 1.875104 *
                       std::sqrt(210e9 * round_section(0.010).second_moment /
                                 (bar.mass * std::pow(0.060, 3))) /
                       (2.0 * std::numbers::pi);
  EXPECT_NEAR(first_period(bar) * euler, 3.51602 / 3.56753, 1e-5);
}

// Timoshenko's sphere on a beam (anchor B10): 1.182 µm without the beam's
// mass, 0.709 µm with 17/35 of it; midspan, hinges 153.5 mm apart, 1 cm².
TEST(BarImpact, TimoshenkosSphereOnABeam) {
  const part::Material material{"steel", 215.746e9, 0.3, 7960.0, 1e9};
  const double a = 0.01;
  const BarSection square{.area = a * a,
                          .second_moment = std::pow(a, 4) / 12.0,
                          .section_modulus = std::pow(a, 3) / 6.0};
  const StruckBar beam = simple_beam(material, square, 0.1535);
  EXPECT_NEAR(beam.mass, 0.12219, 5e-6);
  const Blow blow{.mass = 0.033343, .speed = 0.01, .force = 0.0};
  EXPECT_NEAR(impact(beam, blow).deflection, 1.182e-6, 5e-10);
  EXPECT_NEAR(impact(beam, blow, StruckMass::kMovesAlong).deflection, 0.709e-6,
              5e-10);
}

// Rod struck by a rigid mass: σ = V √(E ρ M/m) (anchor B11).
TEST(BarImpact, RodByTheEnergyMethod) {
  const StruckBar bar = rod(steel(), round_section(0.01), 0.5);
  for (const double ratio : {0.5, 1.0, 4.0}) {
    const Blow blow{.mass = ratio * bar.mass, .speed = 2.0, .force = 0.0};
    EXPECT_NEAR(
        impact(bar, blow).stress / (2.0 * std::sqrt(210e9 * 7850.0 * ratio)),
        1.0, kRoundOff);
  }
}

TEST(LargestSpeed, JustMeetsTheLimit) {
  const StruckBar bar = rod_of_10_mm();
  for (const StruckMass mass :
       {StruckMass::kLeftOut, StruckMass::kMovesAlong}) {
    Blow blow{.mass = 0.2, .speed = 0.0, .force = 8.0};
    blow.speed = largest_speed(bar, blow, 236e6, mass);
    EXPECT_NEAR(impact(bar, blow, mass).stress / 236e6, 1.0, kRoundOff);
  }
  EXPECT_EQ(largest_speed(bar, {.mass = 0.2, .speed = 0.0, .force = 1e6}, 1e6),
            0.0);
}

}  // namespace
}  // namespace clevis::beam
