#include "loads/pressure/pin_pressure.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace clevis::loads {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

// A bore that is aligned with nothing.
part::Bore slanted_bore() {
  return {.p_LC = {0.12, -0.03, 0.02},
          .axis_L = Vector3d(0.3, -0.5, 0.8).normalized(),
          .radius = 7.5e-3,
          .length = 12e-3};
}

/// Unit vector across the axis at an angle.
Vector3d radial(const part::Bore& bore, double angle) {
  const Vector3d e_1 = bore.axis_L.unitOrthogonal();
  return std::cos(angle) * e_1 + std::sin(angle) * bore.axis_L.cross(e_1);
}

/// Midpoints of a fine grid on what there is of a bore's wall.
struct Wall {
  Wall(const part::Bore& bore,
       const std::function<bool(double angle, double height)>& is_there,
       int around = 720, int along = 24) {
    std::vector<Vector3d> places, normals;
    for (int i = 0; i < along; ++i) {
      const double s = bore.length * ((i + 0.5) / along - 0.5);
      for (int k = 0; k < around; ++k) {
        const double angle = 2.0 * kPi * (k + 0.5) / around - kPi;
        if (!is_there(angle, s)) continue;
        const Vector3d e_r = radial(bore, angle);
        places.push_back(bore.p_LC + s * bore.axis_L + bore.radius * e_r);
        normals.push_back(-e_r);
      }
    }
    const auto n = static_cast<Index>(places.size());
    quadrature.points.resize(3, n);
    outward.resize(3, n);
    for (Index q = 0; q < n; ++q) {
      quadrature.points.col(q) = places[static_cast<std::size_t>(q)];
      outward.col(q) = normals[static_cast<std::size_t>(q)];
    }
    quadrature.weights = Eigen::VectorXd::Constant(
        n, 2.0 * kPi * bore.radius * bore.length / (around * along));
  }

  GroupQuadrature quadrature;
  Matrix3Xd outward;
};

void expect_wrench(const Wrench& got, const Wrench& wanted, double length,
                   double tolerance) {
  const double scale = wanted.force.norm() + wanted.moment.norm() / length;
  EXPECT_LT((got.force - wanted.force).norm(), tolerance * scale);
  EXPECT_LT((got.moment - wanted.moment).norm(), tolerance * scale * length);
}

// The elastic layer's pressures where the wall is whole but for a cut that
// counts as open: those of the closed form on a whole one, as the cut goes.
TEST(PinPressure, WallWithASmallGapIsPressedAsAWholeOne) {
  const part::Bore bore = slanted_bore();
  const Wall open(
      bore,
      [](double angle, double) {
        return std::abs(angle) < 0.97 * kPi;
      },
      720, 96);
  const Wrench wrench{.force = 900.0 * radial(bore, 0.0),
                      .moment = 0.8 * radial(bore, 0.5 * kPi)};
  const PinPressure pin(bore, open.quadrature, open.outward);
  ASSERT_FALSE(pin.is_whole());
  const auto pressed = pin.tractions(wrench);
  ASSERT_TRUE(pressed);
  const Matrix3Xd closed = BearingTraction(bore, wrench)
                               .tractions(open.quadrature.points, open.outward);
  // The line load keeps its sign along the axis: the gap behind carries none.
  EXPECT_LT((*pressed - closed).colwise().norm().maxCoeff(),
            1e-4 * closed.colwise().norm().maxCoeff());
}

// A gap of half-angle g before the force: p = k cos t on g < |t| < pi/2,
// F = k r l (pi/2 - g - sin 2g / 2).
TEST(PinPressure, KeywayBeforeTheForceHasTheClosedForm) {
  const part::Bore bore = slanted_bore();
  const double force = 1000.0;
  for (const double gap : {0.1, 0.3, 0.6}) {
    const Wall wall(
        bore,
        [&](double angle, double) {
          return std::abs(angle) > gap;
        },
        14400, 4);
    const Wrench wrench{.force = force * radial(bore, 0.0)};
    const PinPressure pin(bore, wall.quadrature, wall.outward);
    ASSERT_FALSE(pin.is_whole());
    const double k = force / (bore.radius * bore.length *
                              (0.5 * kPi - gap - 0.5 * std::sin(2.0 * gap)));
    const auto largest = pin.largest_pressure(wrench);
    ASSERT_TRUE(largest);
    EXPECT_NEAR(*largest, k * std::cos(gap), 1e-3 * k) << gap;
    const auto pressed = pin.tractions(wrench);
    for (Index q = 0; q < pressed->cols(); ++q) {
      const double cosine = -wall.outward.col(q).dot(radial(bore, 0.0));
      EXPECT_NEAR(pressed->col(q).norm(), k * std::max(0.0, cosine), 1e-3 * k);
    }
  }
}

TEST(PinPressure, ResultantOnOpenWallsIsTheWrench) {
  const part::Bore bore = slanted_bore();
  const Wrench wrench{.force = 700.0 * radial(bore, 0.4) + 90.0 * bore.axis_L,
                      .moment = 1.3 * radial(bore, 2.0) + 0.7 * bore.axis_L};
  for (const auto& [gap, ears] : {std::pair{0.3, false}, {0.7, true}}) {
    const Wall wall(bore, [&](double angle, double s) {
      return std::abs(angle) > gap && !(ears && std::abs(s) < 2e-3);
    });
    const PinPressure pin(bore, wall.quadrature, wall.outward);
    ASSERT_FALSE(pin.is_whole());
    const auto pressed = pin.tractions(wrench);
    ASSERT_TRUE(pressed);
    expect_wrench(resultant(wall.quadrature, *pressed, bore.p_LC), wrench,
                  bore.length, 1e-9);
    // Presses and never pulls.
    EXPECT_LE((pressed->cwiseProduct(wall.outward)).colwise().sum().maxCoeff(),
              1e-9 * pressed->norm());
  }
}

TEST(PinPressure, OpenSaddleCarriesWhatPressesIntoItAlone) {
  const part::Bore bore = slanted_bore();
  const Wall saddle(bore, [](double angle, double) {
    return std::abs(angle) < 0.25 * kPi;
  });
  const PinPressure pin(bore, saddle.quadrature, saddle.outward);
  EXPECT_TRUE(pin.tractions({.force = radial(bore, 0.0)}));
  EXPECT_TRUE(pin.tractions({.force = radial(bore, 0.7)}));
  EXPECT_FALSE(pin.tractions({.force = radial(bore, 0.9)}));
  EXPECT_FALSE(pin.tractions({.force = radial(bore, kPi)}));
}

TEST(PinPressure, WholeWallsKeepTheClosedForm) {
  const part::Bore bore = slanted_bore();
  const Wrench wrench{.force = {700.0, -450.0, 310.0},
                      .moment = {1.3, 0.9, -0.7}};
  const Wall wall(bore, [](double, double) {
    return true;
  });
  const PinPressure pin(bore, wall.quadrature, wall.outward);
  ASSERT_TRUE(pin.is_whole());
  const Matrix3Xd closed = BearingTraction(bore, wrench)
                               .tractions(wall.quadrature.points, wall.outward);
  EXPECT_EQ((*pin.tractions(wrench) - closed).norm(), 0.0);
  EXPECT_NEAR(*pin.largest_pressure(wrench),
              largest_bearing_pressure(bore, wrench, full_wall(bore)),
              0.03 * *pin.largest_pressure(wrench));
}

}  // namespace
}  // namespace clevis::loads
