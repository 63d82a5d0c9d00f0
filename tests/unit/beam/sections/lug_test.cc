#include "beam/sections/lug.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace clevis::beam {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

part::Bore bore_at(const Vector3d& at, double radius = 7.5e-3) {
  return {.p_LC = at,
          .axis_L = Vector3d::UnitZ(),
          .radius = radius,
          .length = 5e-3};
}

void add_circle(Outline& outline, const Vector3d& centre, double radius,
                int sides = 2000) {
  for (int i = 0; i < sides; ++i) {
    const auto at = [&](int k) -> Vector3d {
      const double a = 2.0 * std::numbers::pi * (k + 0.31) / sides;
      return centre + radius * Vector3d(std::cos(a), std::sin(a), 0.0);
    };
    outline.push_back({at(i), at(i + 1)});
  }
}

void add_box(Outline& outline, double x_0, double x_1, double y_0, double y_1) {
  const std::array<Vector3d, 4> c{Vector3d(x_0, y_0, 0), Vector3d(x_1, y_0, 0),
                                  Vector3d(x_1, y_1, 0), Vector3d(x_0, y_1, 0)};
  for (std::size_t i = 0; i < 4; ++i) outline.push_back({c[i], c[(i + 1) % 4]});
}

// Boss 24/15 mm, 5 mm thick, under 1118 N: net section 24.84 MPa; bearing
// 14.9 MPa; two shear planes of 4.5 mm.
TEST(Lug, BossOfTheLandingGear) {
  const part::Bore bore = bore_at({0.1, 0.0, 0.0});
  Outline ring;
  add_circle(ring, bore.p_LC, 7.5e-3);
  add_circle(ring, bore.p_LC, 12e-3);
  const LugGeometry lug(bore, ring);
  ASSERT_TRUE(lug.is_bore());
  const LugStress stress = lug_stress(lug, bore, {1118.0, 0.0, 0.0});
  EXPECT_NEAR(stress.bearing, 1118.0 / (15e-3 * 5e-3), 1.0);
  EXPECT_NEAR(stress.net_section.value(), 1118.0 / (9e-3 * 5e-3), 1e-5 * 25e6);
  EXPECT_NEAR(stress.shear_out.value(),
              std::sqrt(3.0) * 1118.0 / (2.0 * 5e-3 * 4.5e-3), 1e-5 * 43e6);
}

// Bore 10 mm from the right end and 8 mm from the top of a strip.
TEST(Lug, PinThatPushesIntoTheBodyLoadsNoNetSection) {
  const part::Bore bore = bore_at({0.0, 0.0, 0.0}, 5e-3);
  Outline strip;
  add_circle(strip, bore.p_LC, 5e-3);
  add_box(strip, -0.1, 0.01, -0.012, 0.008);
  const LugGeometry lug(bore, strip);
  EXPECT_NEAR(lug.edge({1.0, 0.0, 0.0}), 0.01, 1e-9);
  EXPECT_NEAR(lug.edge({-1.0, 0.0, 0.0}), 0.1, 1e-9);
  EXPECT_NEAR(lug.smallest_edge(), 0.008, 1e-9);
  const LugStress pulled = lug_stress(lug, bore, {100.0, 0.0, 0.0});
  EXPECT_NEAR(pulled.net_section.value(), 100.0 / (0.010 * 5e-3), 1.0);
  EXPECT_NEAR(pulled.shear_out.value(),
              std::sqrt(3.0) * 100.0 / (2.0 * 5e-3 * 5e-3), 1.0);
  const LugStress pushed = lug_stress(lug, bore, {-100.0, 0.0, 0.0});
  EXPECT_FALSE(pushed.net_section.has_value());
  EXPECT_FALSE(pushed.shear_out.has_value());
  EXPECT_EQ(pushed.bearing, pulled.bearing);
}

TEST(Lug, NextBoreEndsTheMaterial) {
  const part::Bore bore = bore_at({0.0, 0.0, 0.0}, 5e-3);
  Outline strip;
  add_circle(strip, bore.p_LC, 5e-3);
  add_circle(strip, {0.03, 0.0, 0.0}, 5e-3);
  add_box(strip, -0.01, 0.1, -0.01, 0.01);
  EXPECT_NEAR(LugGeometry(bore, strip).edge({1.0, 0.0, 0.0}), 0.025, 1e-6);
}

TEST(Lug, JournalIsToldFromABore) {
  const part::Bore journal = bore_at({0.0, 0.0, 0.0}, 5e-3);
  Outline shaft;
  add_circle(shaft, journal.p_LC, 5e-3);
  const LugGeometry lug(journal, shaft);
  EXPECT_FALSE(lug.is_bore());
  const LugStress stress = lug_stress(lug, journal, {0.0, 50.0, 0.0});
  EXPECT_FALSE(stress.net_section.has_value());
  EXPECT_NEAR(stress.bearing, 50.0 / (10e-3 * 5e-3), 1e-6);
}

TEST(Lug, TurnsWithThePart) {
  const Matrix3d R =
      Eigen::AngleAxisd(1.0, Vector3d(1.0, -2.0, 0.5).normalized())
          .toRotationMatrix();
  part::Bore bore = bore_at({0.0, 0.0, 0.0}, 5e-3);
  Outline strip;
  add_circle(strip, bore.p_LC, 5e-3);
  add_box(strip, -0.1, 0.01, -0.012, 0.008);
  Outline turned;
  for (const auto& [a, b] : strip) turned.push_back({R * a, R * b});
  part::Bore turned_bore = bore;
  turned_bore.axis_L = R * bore.axis_L;
  const Vector3d force(80.0, 30.0, 5.0);
  const LugStress a = lug_stress(LugGeometry(bore, strip), bore, force);
  const LugStress b =
      lug_stress(LugGeometry(turned_bore, turned), turned_bore, R * force);
  // Edges are tabulated every degree: cos(½°) is 4e-5 below 1.
  EXPECT_NEAR(*a.net_section, *b.net_section, 5e-4 * *a.net_section);
  EXPECT_NEAR(*a.shear_out, *b.shear_out, 5e-4 * *a.shear_out);
}

}  // namespace
}  // namespace clevis::beam
