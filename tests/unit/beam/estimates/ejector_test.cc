// The ejector of the source with assumed numbers, whose table was worked out
// apart from this code: 466.5, 804.4, 235.7, 453.8, 444.3 MPa.
#include "beam/estimates/ejector.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace clevis::beam {
namespace {

machine::EjectorDefinition example() {
  machine::EjectorDefinition e;
  e.arm_magnet = 0.040;
  e.arm_pusher = 0.100;
  e.arm_spring = 0.030;
  e.inertia = 2e-3;
  e.magnet_force = 60.0;
  e.magnet_range = 0.010;
  e.travel = 0.005;
  e.spring_stiffness = 2000.0;
  e.spring_preset = 0.003;
  e.workpiece = {"steel_45", 210e9, 0.3, 7850.0, 355e6};
  e.diameter = 0.010;
  e.length = 0.060;
  e.safety_factor = 1.5;
  return e;
}

TEST(Ejector, DriveOfTheExample) {
  const EjectorDrive corrected = ejector_drive(example());
  EXPECT_NEAR(*corrected.pusher_speed, 1.3727, 5e-5);
  EXPECT_NEAR(corrected.pusher_force, 7.95, 1e-12);
  EXPECT_NEAR(corrected.pusher_mass, 0.2, 1e-15);
  EXPECT_NEAR(*ejector_drive(example(), Formula::kPublished).pusher_speed,
              1.2224, 5e-5);
}

TEST(Ejector, TableOfTheFormulas) {
  struct Row {
    double stress, deflection, factor;
  };
  // y_st + √(y_st² + m V²/k) of the first row: 0.0167 + 1.5828 mm
  constexpr std::array kRows{Row{466.5, 1.5995, 96.0}, Row{804.4, 0.919, 165.6},
                             Row{235.7, 0.808, 48.5}, Row{453.8, 0.519, 93.4},
                             Row{444.3, 0.508, 91.5}};
  const auto variants = ejector_variants(example());
  ASSERT_EQ(variants.size(), kRows.size());
  for (std::size_t i = 0; i < kRows.size(); ++i) {
    const BarImpact& found = *variants[i].impact;
    EXPECT_NEAR(found.stress / 1e6, kRows[i].stress, 0.05) << i;
    EXPECT_NEAR(found.deflection * 1e3, kRows[i].deflection, 0.0005) << i;
    EXPECT_NEAR(*found.factor, kRows[i].factor, 0.05) << i;
  }
}

// The work of magnet and spring, by quadrature of their forces.
TEST(Ejector, EnergyIsTheWorkOfTheForces) {
  const auto e = example();
  double work = 0.0;
  constexpr int kPieces = 1000;
  for (int i = 0; i < kPieces; ++i) {
    const double s = e.travel * (i + 0.5) / kPieces;
    const double squeezed = e.spring_preset + s * e.arm_spring / e.arm_magnet;
    work += (e.magnet_force * (1.0 - s / e.magnet_range) -
             e.spring_stiffness * squeezed * e.arm_spring / e.arm_magnet) *
            e.travel / kPieces;
  }
  // the midpoint rule is exact for linear forces
  EXPECT_NEAR(ejector_drive(e).energy / work, 1.0, 1e-12);
}

// As printed the spring has energy before anything moved: V_B is imaginary.
TEST(Ejector, PublishedSpringStopsAShortTravel) {
  auto e = example();
  e.travel = 1e-4;
  EXPECT_FALSE(ejector_drive(e, Formula::kPublished).pusher_speed);
  EXPECT_TRUE(ejector_drive(e).pusher_speed);
  EXPECT_FALSE(ejector_variants(e)[0].impact);
  EXPECT_FALSE(strength_condition(e, Formula::kPublished));
}

// (6) with J_C once is (1) with (2) and (5); as printed it is off by 1/√J_C
// in SI units, and the 1 under the root.
TEST(Ejector, StrengthConditionHoldsTheInertiaOnce) {
  const double corrected = *strength_condition(example(), Formula::kCorrected);
  EXPECT_NEAR(corrected / 1e6, 466.5, 0.05);
  const double published = *strength_condition(example(), Formula::kPublished);
  const double still = 7.95 * 0.060 / round_section(0.010).section_modulus;
  EXPECT_NEAR(
      (published / still - 1.0) / (corrected / still - 1.0) * std::sqrt(2e-3),
      1.0, 1e-4);
}

TEST(EjectorLimits, AreWhereTheStressMeetsTheLimit) {
  const auto e = example();
  const EjectorLimits limits = ejector_limits(e);
  const double allowed = 355e6 / 1.5;
  EXPECT_NEAR(limits.stress, allowed, 1e-6);
  const auto stress_at = [&](double machine::EjectorDefinition::*quantity,
                             double value) {
    auto changed = e;
    changed.*quantity = value;
    return ejector_impact(changed, {})->stress;
  };
  using E = machine::EjectorDefinition;
  for (const auto& [quantity, value] :
       {std::pair{&E::magnet_force, *limits.magnet_force},
        std::pair{&E::travel, *limits.travel}}) {
    EXPECT_NEAR(stress_at(quantity, value) / allowed, 1.0, 1e-9);
    EXPECT_LT(stress_at(quantity, 0.99 * value), allowed);
    EXPECT_GT(stress_at(quantity, 1.01 * value), allowed);
  }
  EXPECT_LT(limits.speed, *ejector_drive(e).pusher_speed);
}

TEST(EjectorLimits, AnyAndNone) {
  auto e = example();
  e.workpiece.yield_strength = 1e12;
  EXPECT_FALSE(ejector_limits(e).travel);
  EXPECT_FALSE(ejector_limits(e).range);
  e.workpiece.yield_strength = 1e6;
  EXPECT_EQ(*ejector_limits(e).range, 0.0);
}

}  // namespace
}  // namespace clevis::beam
