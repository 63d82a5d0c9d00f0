#include "beam/sections/station.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "unit/beam/bar.h"

namespace clevis::beam {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Station rectangle(double height, double width) {
  const Bar bar{.start = -1.0, .end = 1.0, .height = height, .width = width};
  return Station(bar.section(Vector3d::Zero()), Vector3d::UnitX(), {});
}

Station ring(double radius, double bore) {
  const double pi = std::numbers::pi;
  mesh::Section s;
  s.area = pi * (radius * radius - bore * bore);
  const double I = pi * (std::pow(radius, 4) - std::pow(bore, 4)) / 4.0;
  s.second_moment.diagonal() << 0.0, I, I;
  for (int i = 0; i < 400; ++i) {
    const double a = 2.0 * pi * i / 400;
    s.rim.emplace_back(0.0, radius * std::cos(a), radius * std::sin(a));
  }
  return Station(s, Vector3d::UnitX(), {});
}

// 40 N m on 18 × 5 mm are 148.1 MPa.
TEST(Station, BendingOfBC) {
  const Station s = rectangle(18e-3, 5e-3);
  EXPECT_NEAR(s.fibre_stress({.moment = {0.0, 0.0, 40.0}}), 40.0 / 270e-9, 1.0);
}

// The gradient is a stress field whose moment is the given one.
TEST(Station, BendingGradientCarriesTheMoment) {
  const Station s = rectangle(18e-3, 5e-3);
  const Vector3d M(0.0, 7.0, -3.0);
  const Vector3d g = s.bending_gradient(M);
  Vector3d sum = Vector3d::Zero();
  const double q = 0.5 / std::sqrt(3.0);
  for (const double y : {-q, q}) {
    for (const double z : {-q, q}) {
      const Vector3d r(0.0, y * 18e-3, z * 5e-3);
      const Vector3d pull = g.dot(r) * 0.25 * 90e-6 * Vector3d::UnitX();
      sum += r.cross(pull);
    }
  }
  EXPECT_LT((sum - M).norm(), 1e-12 * M.norm());
}

TEST(Station, AxialAndBothBendingsMeetInACorner) {
  const Station s = rectangle(20e-3, 5e-3);
  const double wanted = 1000.0 / 100e-6 + 5.0 * 6.0 / (5e-3 * 400e-6) +
                        0.5 * 6.0 / (20e-3 * 25e-6);
  EXPECT_NEAR(
      s.fibre_stress({.force = {1000.0, 0.0, 0.0}, .moment = {0.0, 0.5, 5.0}}),
      wanted, 1e-9 * wanted);
}

TEST(Station, SkewRectangleBendsAboutItsPrincipalAxes) {
  const Matrix3d R =
      Eigen::AngleAxisd(0.6, Vector3d::UnitX()).toRotationMatrix();
  const Bar bar{.start = -1.0, .end = 1.0, .height = 20e-3, .width = 5e-3};
  mesh::Section section = bar.section(Vector3d::Zero());
  section.second_moment = R * section.second_moment * R.transpose();
  for (Vector3d& p : section.rim) p = R * p;
  const Station skew(section, Vector3d::UnitX(), {});
  const Station straight = rectangle(20e-3, 5e-3);
  const loads::Wrench w{.force = {300.0, 20.0, -10.0},
                        .moment = {0.4, 0.3, 2.0}};
  const loads::Wrench turned{.force = R * w.force, .moment = R * w.moment};
  EXPECT_NEAR(skew.fibre_stress(turned), straight.fibre_stress(w),
              1e-9 * straight.fibre_stress(w));
  EXPECT_NEAR(skew.smallest_second_moment(), 20e-3 * std::pow(5e-3, 3) / 12.0,
              1e-20);
}

TEST(Station, ShearOfARectangleIsParabolic) {
  const Station s = rectangle(20e-3, 5e-3);
  EXPECT_NEAR(s.neutral_axis_stress({.force = {0.0, 300.0, 400.0}}),
              std::sqrt(3.0) * 1.5 * 500.0 / 100e-6, 1.0);
}

// Thin strip: exactly 3T/(h w²), met from above by 40.5/36.
TEST(Station, TorsionIsSafeForStrips) {
  const Station strip = rectangle(2000e-3, 2e-3);
  const double thin = 3.0 * 1.0 / (2000e-3 * 4e-6);
  EXPECT_NEAR(strip.fibre_stress({.moment = {1.0, 0.0, 0.0}}),
              std::sqrt(3.0) * 1.125 * thin, 1e-5 * thin);
}

// 2 T r / (π (r⁴ − b⁴)).
TEST(Station, TorsionOfRodsAndTubesIsExact) {
  for (const double bore : {0.0, 4e-3, 4.9e-3}) {
    const double exact =
        2.0 * 5e-3 /
        (std::numbers::pi * (std::pow(5e-3, 4) - std::pow(bore, 4)));
    EXPECT_NEAR(ring(5e-3, bore).fibre_stress({.moment = {1.0, 0.0, 0.0}}),
                std::sqrt(3.0) * exact, 1e-9 * exact);
  }
}

/// √3 τ of a torque of 1 N m alone, as τ [Pa].
double torsion_of(const Station& station) {
  return station.fibre_stress({.moment = {1.0, 0.0, 0.0}}) / std::sqrt(3.0);
}

// Exact: 4.808 T/a³ of a square, which has as even second moments and is no
// ring; T/(0.246 b t²) of sides 2 : 1, 0.267 of 3 : 1, 0.282
// of 4 : 1 (Timoshenko).
TEST(Station, TorsionOfRectanglesIsSafeAndClose) {
  struct {
    double height, exact;
  } const cases[] = {
      {1.0, 4.808}, {2.0, 1 / 0.492}, {3.0, 1 / 0.801}, {4.0, 1 / 1.128}};
  for (const auto& [height, exact] : cases) {
    const double found = torsion_of(rectangle(height * 10e-3, 10e-3)) * 1e-6;
    EXPECT_GT(found, exact) << height;
    EXPECT_LT(found, 1.11 * exact) << height;
  }
}

// Equilateral triangle: 20 T/a³.
TEST(Station, TorsionOfATriangleIsSafeAndClose) {
  const double a = 10e-3;
  mesh::Section s;
  s.area = std::sqrt(3.0) / 4.0 * a * a;
  const double I = std::sqrt(3.0) / 96.0 * std::pow(a, 4);
  s.second_moment.diagonal() << 0.0, I, I;
  for (int i = 0; i < 3; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 3;
    s.rim.emplace_back(0.0, a / std::sqrt(3.0) * std::cos(angle),
                       a / std::sqrt(3.0) * std::sin(angle));
  }
  const double found =
      torsion_of(Station(s, Vector3d::UnitX(), {})) * a * a * a;
  EXPECT_GT(found, 20.0);
  EXPECT_LT(found, 1.05 * 20.0);
}

// A shaft of d 30 with a keyway 8 × 4: 1.49 times the plain shaft's stress at
// the middle of the keyway's bottom, by Prandtl's function on a grid of
// 0.05 mm.
TEST(Station, TorsionOfAKeyedShaftIsClose) {
  const double pi = std::numbers::pi;
  const double r = 15e-3;
  mesh::Section s;
  s.area = pi * r * r - 8e-3 * 4e-3;
  const double cut = 13e-3 * 8e-3 * 4e-3;  // first moment of the keyway
  const double shift = -cut / s.area;
  const double across = pi / 4 * std::pow(r, 4);
  const double Iy = across - (8e-3 * std::pow(4e-3, 3) / 12 + 13e-3 * cut) -
                    s.area * shift * shift;
  const double Iz = across - 4e-3 * std::pow(8e-3, 3) / 12;
  s.second_moment.diagonal() << 0.0, Iy, Iz;
  for (int i = 0; i < 400; ++i) {
    const double a = 2.0 * pi * i / 400;
    const double y = r * std::cos(a);
    const double z = r * std::sin(a);
    if (y < 0 || std::abs(z) > 4e-3) s.rim.emplace_back(0.0, y - shift, z);
  }
  const double plain = 2.0 / (pi * std::pow(r, 3));
  const double found = torsion_of(Station(s, Vector3d::UnitX(), {}));
  EXPECT_NEAR(found, 1.49 * plain, 0.03 * 1.49 * plain);
}

TEST(Station, IsTwistedWhereTorsionCounts) {
  const Station s = ring(5e-3, 0.0);
  EXPECT_FALSE(s.is_twisted({.moment = {0.1, 1.0, 0.0}}));
  EXPECT_TRUE(s.is_twisted({.moment = {1.0, 1.0, 0.0}}));
}

}  // namespace
}  // namespace clevis::beam
