#include "machine/transmissions/compliance.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace clevis::machine {
namespace {

constexpr double kPi = std::numbers::pi;

template <typename Law>
double of(const Law& law, BallScrewUnit unit = BallScrewUnit::kCorrected) {
  return compliance({"e", law, ""}, unit);
}

// Values of the source's examples, printed in N and mm.
TEST(Compliance, OfShaftsKeysTeethAndThreads) {
  constexpr double kPerNmm = 1e3;  // 1/(N mm) to 1/(N m)
  EXPECT_NEAR(of(Bar{0.1, 2e-4, 2.1e11}), 0.1 / (2.1e11 * 2e-4), 1e-24);
  // d = 25 mm: J_p = 38349.5 mm^4
  EXPECT_NEAR(of(Shaft{0.05, 0.025, 0.0, 8.1e10}),
              50.0 / (8.1e4 * kPi * std::pow(25.0, 4) / 32.0) * kPerNmm, 1e-18);
  // r_w = 20, b = 15: 1.149e-8 rad/(N mm)
  EXPECT_NEAR(of(GearTeeth{0.02, 0.015, 1.45e10}), 1.149e-8 * kPerNmm,
              0.0005e-8 * kPerNmm);
  // d = 20, l = 30, h = 3: 6.5e-3/36000
  EXPECT_NEAR(of(Key{0.02, 0.03, 0.003, 1, 6.5e-12}),
              6.5e-3 / 36000.0 * kPerNmm, 1e-16);
  EXPECT_NEAR(of(Key{0.02, 0.03, 0.003, 6, 4e-12, true}),
              4e-3 / (6.0 * 36000.0) * kPerNmm, 1e-16);
  const double area = kPi / 4.0 * (64.0 - 6.466 * 6.466);
  EXPECT_NEAR(of(Thread{0.008, 0.006466, 0.7e-12}), 0.7e-3 / area * 1e-3,
              1e-20);
}

// A bore takes away its own stiffness.
TEST(Compliance, OfAHollowShaft) {
  const double solid = of(Shaft{0.1, 0.03, 0.0, 8.1e10});
  const double core = of(Shaft{0.1, 0.02, 0.0, 8.1e10});
  const double tube = of(Shaft{0.1, 0.03, 0.02, 8.1e10});
  EXPECT_NEAR(1.0 / tube, 1.0 / solid - 1.0 / core, 1e-9 / solid);
}

// d_o = 20, d = 3, K_B = 3, F = 500: 328 N/µm, not 328 N/mm as printed.
TEST(Compliance, OfABallScrewInBothUnits) {
  const BallScrew screw{0.020, 0.003, 3.0, 500.0, 1.0};
  EXPECT_NEAR(1e-6 / of(screw), 328.0, 0.5);
  EXPECT_NEAR(of(screw, BallScrewUnit::kPublished) / of(screw), 1000.0, 1e-9);
  // Hertz: twice the load is 2^(1/3) times as stiff, to the digits of 0.33
  const BallScrew tight{0.020, 0.003, 3.0, 1000.0, 1.0};
  EXPECT_NEAR(of(screw) / of(tight), std::cbrt(2.0), 0.003);
}

// Energy of springs: in parallel all stretch by x, in series all carry F.
TEST(Compliance, OfElementsInParallelAndSeries) {
  const CompliantElement a{"a", GivenCompliance{2e-6, false}, ""};
  const CompliantElement b{"b", GivenCompliance{3e-6, false}, ""};
  EXPECT_NEAR(of(ElementGroup{true, {a, b}}), 1.2e-6, 1e-20);
  EXPECT_NEAR(of(ElementGroup{false, {a, b}}), 5e-6, 1e-20);
  const CompliantElement pair{"pair", ElementGroup{true, {a, a}}, ""};
  EXPECT_NEAR(of(ElementGroup{false, {pair, b}}), 4e-6, 1e-20);
  EXPECT_FALSE(is_angular(pair));
  EXPECT_STREQ(type_name(pair), "parallel");
}

TEST(Compliance, ScalesWithTheUnitOfLength) {
  // all lengths by s: bars and threads by 1/s … as their dimension says
  const double s = 3.0;
  const auto ratio = [&](const auto& small, const auto& large) {
    return of(large) / of(small);
  };
  EXPECT_NEAR(ratio(Bar{1.0, 1.0, 1.0}, Bar{s, s * s, 1.0}), 1.0 / s, 1e-12);
  EXPECT_NEAR(ratio(Shaft{1.0, 1.0, 0.5, 1.0}, Shaft{s, s, 0.5 * s, 1.0}),
              std::pow(s, -3), 1e-12);
  EXPECT_NEAR(ratio(GearTeeth{1.0, 1.0, 1.0}, GearTeeth{s, s, 1.0}),
              std::pow(s, -3), 1e-12);
}

}  // namespace
}  // namespace clevis::machine
