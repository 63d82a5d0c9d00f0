// Williams' exponents against published values and the closed equations of
// the three classical wedges, solved here by another way (bisection on the
// real axis).

#include "stress/corners/wedge_exponent.h"

#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

namespace clevis::stress {
namespace {

using std::numbers::pi;

constexpr double kDegree = pi / 180.0;
constexpr double kTolerance = 2e-7;
const WedgeSide kFree{};
const WedgeSide kClamped{WedgeSide::Hold::kBoth, 0.0};
const WedgeSide kNormalHeld{WedgeSide::Hold::kOneDirection, pi / 2};
const WedgeSide kTangentHeld{WedgeSide::Hold::kOneDirection, 0.0};

/// Smallest real zero in (0.05, 0.994), or 1.
double first_zero(const std::function<double(double)>& f) {
  constexpr int kSteps = 4000;
  double low = 0.05;
  for (int k = 1; k <= kSteps; ++k) {
    double high = 0.05 + 0.944 * k / kSteps;
    if (f(low) * f(high) <= 0.0) {
      for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (f(low) * f(middle) <= 0.0 ? high : low) = middle;
      }
      return low;
    }
    low = high;
  }
  return 1.0;
}

double smallest(double angle, const WedgeSide& first, const WedgeSide& second,
                double kolosov) {
  const auto all = wedge_exponents(angle, first, second, kolosov);
  return all.empty() ? 1.0 : all.front();
}

TEST(WedgeExponent, RightAngledNotchHasThePublishedPair) {
  for (const double nu : {0.0, 0.3, 0.49}) {
    const auto all =
        wedge_exponents(1.5 * pi, kFree, kFree, kolosov_plane_strain(nu));
    ASSERT_EQ(all.size(), 2u);
    EXPECT_NEAR(all[0], 0.5444837368, kTolerance);
    EXPECT_NEAR(all[1], 0.9085291898, kTolerance);
  }
}

TEST(WedgeExponent, CrackHasADoubleRootOfOneHalf) {
  const auto all =
      wedge_exponents(2.0 * pi, kFree, kFree, kolosov_plane_stress(0.3));
  ASSERT_EQ(all.size(), 2u);
  EXPECT_NEAR(all[0], 0.5, 1e-6);
  EXPECT_NEAR(all[1], 0.5, 1e-6);
}

TEST(WedgeExponent, ClampedEdgeHasThePublishedValues) {
  const double values[][2] = {
      {0.25, 0.744750}, {0.3, 0.711173}, {0.33, 0.692065}, {0.49, 0.599895}};
  for (const auto& [nu, lambda] : values) {
    const double kolosov = kolosov_plane_strain(nu);
    EXPECT_NEAR(smallest(pi / 2, kClamped, kFree, kolosov), lambda, 1e-6);
    EXPECT_NEAR(smallest(pi / 2, kFree, kClamped, kolosov), lambda, 1e-6);
  }
}

// ν = 0: a clamped end does not hinder the width.
TEST(WedgeExponent, ClampedEdgeWithoutPoissonEffectIsSmooth) {
  EXPECT_EQ(smallest(pi / 2, kClamped, kFree, kolosov_plane_strain(0.0)), 1.0);
}

// On a half-plane clamped beside a free edge the exponent is complex,
// ½ + i ln κ / 2π: its real part counts.
TEST(WedgeExponent, ChangeOfSupportOnAStraightEdgeIsOneHalf) {
  for (const double nu : {0.1, 0.3, 0.45}) {
    const double kolosov = kolosov_plane_strain(nu);
    EXPECT_NEAR(smallest(pi, kClamped, kFree, kolosov), 0.5, kTolerance);
    EXPECT_NEAR(smallest(pi, kNormalHeld, kFree, kolosov), 0.5, 1e-6);
  }
}

TEST(WedgeExponent, MatchesTheEquationsOfWilliams) {
  const double kolosov = kolosov_plane_stress(0.3);
  for (const double degrees : {200.0, 225.0, 250.0, 300.0, 330.0, 350.0}) {
    const double w = degrees * kDegree;
    const double free_free = first_zero([&](double l) {
      return std::sin(l * w) + l * std::sin(w);
    });
    EXPECT_NEAR(smallest(w, kFree, kFree, kolosov), free_free, kTolerance);
    const double clamped =
        std::min(first_zero([&](double l) {
                   return std::sin(l * w) - l / kolosov * std::sin(w);
                 }),
                 first_zero([&](double l) {
                   return std::sin(l * w) + l / kolosov * std::sin(w);
                 }));
    EXPECT_NEAR(smallest(w, kClamped, kClamped, kolosov), clamped, kTolerance)
        << degrees;
  }
  for (const double degrees : {70.0, 90.0, 110.0, 120.0}) {
    const double w = degrees * kDegree;
    const double mixed = first_zero([&](double l) {
      return std::pow(std::sin(l * w), 2) -
             (std::pow(kolosov + 1.0, 2) - std::pow(2.0 * l * std::sin(w), 2)) /
                 (4.0 * kolosov);
    });
    EXPECT_NEAR(smallest(w, kClamped, kFree, kolosov), mixed, kTolerance)
        << degrees;
  }
}

// A roller is a plane of symmetry: the wedge and its mirror image.
TEST(WedgeExponent, RollerDoublesTheAngle) {
  const double kolosov = kolosov_plane_strain(0.3);
  EXPECT_EQ(smallest(pi / 2, kNormalHeld, kFree, kolosov), 1.0);
  for (const double degrees : {100.0, 135.0, 160.0}) {
    const double w = degrees * kDegree;
    const double lambda = first_zero([&](double l) {
      return std::sin(l * 2.0 * w) + l * std::sin(2.0 * w);
    });
    EXPECT_NEAR(smallest(w, kNormalHeld, kFree, kolosov), lambda, kTolerance);
  }
  EXPECT_NEAR(smallest(0.75 * pi, kNormalHeld, kFree, kolosov), 0.5444837368,
              kTolerance);
}

// Tangent held: the antisymmetric half of the doubled wedge.
TEST(WedgeExponent, HeldTangentIsTheAntisymmetricHalf) {
  EXPECT_NEAR(
      smallest(0.75 * pi, kTangentHeld, kFree, kolosov_plane_strain(0.3)),
      0.9085291898, kTolerance);
}

TEST(WedgeExponent, ConvexFreeCornersAreSmooth) {
  for (const double degrees : {30.0, 90.0, 135.0, 179.0, 180.0}) {
    EXPECT_TRUE(wedge_exponents(degrees * kDegree, kFree, kFree, 1.8).empty())
        << degrees;
  }
}

TEST(WedgeExponent, AntiplaneIsPiOverTheAngle) {
  EXPECT_NEAR(antiplane_exponent(1.5 * pi, false, false), 2.0 / 3.0, 1e-15);
  EXPECT_NEAR(antiplane_exponent(1.5 * pi, true, true), 2.0 / 3.0, 1e-15);
  EXPECT_NEAR(antiplane_exponent(pi / 2, true, false), 1.0, 1e-15);
}

}  // namespace
}  // namespace clevis::stress
