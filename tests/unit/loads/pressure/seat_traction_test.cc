#include "loads/pressure/seat_traction.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "unit/loads/pressure/wall_quadrature.h"

namespace clevis::loads {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// A bore that is aligned with nothing.
part::Bore slanted_bore() {
  return {.p_LC = {0.12, -0.03, 0.02},
          .axis_L = Vector3d(0.3, -0.5, 0.8).normalized(),
          .radius = 7.5e-3,
          .length = 5e-3};
}

const Wrench kWrench{.force = {700.0, -450.0, 310.0},
                     .moment = {1.3, 0.9, -0.7}};

enum class Surface { kBore, kJournal };

Vector3d outward(Surface surface, const Vector3d& e_r) {
  return surface == Surface::kBore ? Vector3d(-e_r) : e_r;
}

// Where the pressure turns to zero at height s, from statics alone.
Vector3d line_load(const part::Bore& bore, const Wrench& wrench, double s) {
  const Vector3d& a = bore.axis_L;
  const Vector3d normal = wrench.force - a.dot(wrench.force) * a;
  return normal / bore.length +
         12.0 * s / std::pow(bore.length, 3) * wrench.moment.cross(a);
}

Wrench resultant_of(const part::Bore& bore, const Wrench& wrench,
                    Surface surface) {
  const BearingTraction load(bore, wrench);
  return integrate_over_wall(
      bore,
      [&](double s) {
        return line_load(bore, wrench, s);
      },
      [&](const Vector3d& p_LQ, const Vector3d& e_r) {
        return load.traction(p_LQ, outward(surface, e_r));
      });
}

// Cells end at the kink, hence round-off only: 1e-12 of force, and of moment
// over a length of the bore's size.
void expect_wrench(const Wrench& got, const Wrench& wanted, double length) {
  const double scale = wanted.force.norm() + wanted.moment.norm() / length;
  EXPECT_LT((got.force - wanted.force).norm(), 1e-12 * scale);
  EXPECT_LT((got.moment - wanted.moment).norm(), 1e-12 * scale * length);
}

TEST(BearingTraction, ResultantOnABoreIsTheWrench) {
  expect_wrench(resultant_of(slanted_bore(), kWrench, Surface::kBore), kWrench,
                5e-3);
}

TEST(BearingTraction, ResultantOnAJournalIsTheWrench) {
  expect_wrench(resultant_of(slanted_bore(), kWrench, Surface::kJournal),
                kWrench, 5e-3);
}

TEST(BearingTraction, PureMomentsHaveNoForce) {
  const Wrench moment{.moment = {0.4, -2.0, 1.1}};
  expect_wrench(resultant_of(slanted_bore(), moment, Surface::kBore), moment,
                5e-3);
}

// Ears of 4 mm and 6 mm with 10 mm between them carry the wrench together.
TEST(BearingTraction, ResultantOnUnequalEarsIsTheWrench) {
  const part::Bore bore{.p_LC = {0.1, 0.0, 0.0},
                        .axis_L = Vector3d::UnitZ(),
                        .radius = 5e-3,
                        .length = 20e-3};
  constexpr int kAround = 720, kAlong = 400;
  struct {
    Eigen::Matrix3Xd points;
    Eigen::VectorXd weights;
  } ears;
  std::vector<Vector3d> points;
  for (int i = 0; i < kAlong; ++i) {
    const double s = bore.length * ((i + 0.5) / kAlong - 0.5);
    if (-6e-3 < s && s < 4e-3) continue;
    for (int j = 0; j < kAround; ++j) {
      const double theta = 2.0 * std::numbers::pi * j / kAround;
      points.push_back(bore.p_LC + Vector3d(bore.radius * std::cos(theta),
                                            bore.radius * std::sin(theta), s));
    }
  }
  ears.points.resize(3, static_cast<Eigen::Index>(points.size()));
  Eigen::Matrix3Xd inwards = ears.points;
  for (std::size_t q = 0; q < points.size(); ++q) {
    ears.points.col(static_cast<Eigen::Index>(q)) = points[q];
    inwards.col(static_cast<Eigen::Index>(q)) =
        -((points[q] - bore.p_LC).array() * Eigen::Array3d(1, 1, 0))
             .matrix()
             .normalized();
  }
  ears.weights = Eigen::VectorXd::Constant(
      ears.points.cols(),
      2.0 * std::numbers::pi * bore.radius * bore.length / (kAround * kAlong));
  const Wrench wanted{.force = {900.0, -300.0, 50.0},
                      .moment = {1.5, 2.0, 0.3}};
  const WallMoments wall = wall_of(bore, ears.points, ears.weights);
  EXPECT_NEAR(wall.length, 10e-3, 1e-14);
  const Eigen::Matrix3Xd tractions =
      BearingTraction(bore, wanted, wall)
          .tractions(WallPoints(bore, ears.points, inwards));
  Wrench got;
  for (Eigen::Index q = 0; q < tractions.cols(); ++q) {
    const Vector3d force = ears.weights[q] * tractions.col(q);
    got.force += force;
    got.moment += (ears.points.col(q) - bore.p_LC).cross(force);
  }
  // The half cosine's kink lies between the points: an error of their
  // distance squared, (2 pi / 720)^2.
  EXPECT_LT((got.force - wanted.force).norm(), 1e-4 * wanted.force.norm());
  EXPECT_LT((got.moment - wanted.moment).norm(), 1e-4 * wanted.moment.norm());
}

TEST(BearingTraction, PeakPressureMatchesHandCalculation) {
  const part::Bore bore{.p_LC = {0.1, 0.0, 0.0},
                        .axis_L = Vector3d::UnitZ(),
                        .radius = 5e-3,
                        .length = 4e-3};
  const BearingTraction load(bore, {.force = {1000.0, 0.0, 0.0}});
  // 2 * 1000 N / (pi * 5 mm * 4 mm) = 31.8310 MPa, written to six digits.
  const Vector3d t =
      load.traction({0.105, 0.0, 1e-3}, Vector3d(-1.0, 0.0, 0.0));
  EXPECT_NEAR(t.x(), 31.8310e6, 50.0);
  EXPECT_EQ(t.y(), 0.0);
}

// A pin in a bore presses on the wall that the force points at; a ring about
// a journal on the opposite one.
TEST(BearingTraction, TheFarHalfIsFree) {
  const part::Bore bore{.p_LC = Vector3d::Zero(),
                        .axis_L = Vector3d::UnitZ(),
                        .radius = 5e-3,
                        .length = 4e-3};
  const BearingTraction load(bore, {.force = {1000.0, 0.0, 0.0}});
  for (const double theta : {0.0, 0.7, -1.5}) {
    const Vector3d e_r(std::cos(theta), std::sin(theta), 0.0);
    const Vector3d near = bore.radius * e_r;
    const Vector3d far = -near;
    EXPECT_GT(load.traction(near, -e_r).x(), 0.0);
    EXPECT_EQ(load.traction(far, e_r), Vector3d::Zero());
    EXPECT_EQ(load.traction(near, e_r), Vector3d::Zero());
    EXPECT_GT(load.traction(far, -e_r).x(), 0.0);
  }
}

TEST(BearingTraction, PressesAndNeverPulls) {
  const part::Bore bore = slanted_bore();
  const Vector3d& a = bore.axis_L;
  Wrench wrench = kWrench;  // without shear along and about the axis
  wrench.force -= a.dot(wrench.force) * a;
  wrench.moment -= a.dot(wrench.moment) * a;
  const BearingTraction load(bore, wrench);
  const Vector3d e_1 = a.unitOrthogonal();
  for (int i = 0; i < 60; ++i) {
    const Vector3d e_r = Eigen::AngleAxisd(0.1 * i, a) * e_1;
    for (const double s : {-2.4e-3, -1e-3, 0.0, 2e-3}) {
      const Vector3d t =
          load.traction(bore.p_LC + s * a + bore.radius * e_r, -e_r);
      EXPECT_GE(t.dot(e_r), -1e-12);  // of ~1e7 Pa
      EXPECT_LT(t.cross(e_r).norm(), 1e-9 * (1.0 + t.norm()));
    }
  }
}

TEST(BearingTraction, TurnsWithThePart) {
  const Matrix3d R =
      Eigen::AngleAxisd(1.1, Vector3d(1.0, 2.0, -0.5).normalized())
          .toRotationMatrix();
  const part::Bore bore = slanted_bore();
  part::Bore turned = bore;
  turned.p_LC = R * bore.p_LC;
  turned.axis_L = R * bore.axis_L;
  const BearingTraction load(bore, kWrench);
  const BearingTraction turned_load(
      turned, {.force = R * kWrench.force, .moment = R * kWrench.moment});
  const Vector3d e_1 = bore.axis_L.unitOrthogonal();
  for (int i = 0; i < 20; ++i) {
    const Vector3d e_r = Eigen::AngleAxisd(0.3 * i, bore.axis_L) * e_1;
    const Vector3d p = bore.p_LC + 1e-3 * bore.axis_L + bore.radius * e_r;
    const Vector3d wanted = R * load.traction(p, -e_r);
    const Vector3d got = turned_load.traction(R * p, R * -e_r);
    EXPECT_LT((got - wanted).norm(), 1e-12 * kWrench.force.norm() / 1e-5);
  }
}

// An axial force is carried by shear 2πrl wide, a moment about the axis by
// shear on the arm r.
TEST(BearingTraction, AxialForceAndTorqueAreUniformShear) {
  const part::Bore bore{.p_LC = Vector3d::Zero(),
                        .axis_L = Vector3d::UnitZ(),
                        .radius = 0.01,
                        .length = 0.02};
  const BearingTraction load(
      bore, {.force = {0.0, 0.0, 50.0}, .moment = {0.0, 0.0, 3.0}});
  const double wall = 2.0 * std::numbers::pi * 0.01 * 0.02;
  const Vector3d t = load.traction({0.0, 0.01, 0.004}, {0.0, -1.0, 0.0});
  EXPECT_NEAR(t.z(), 50.0 / wall, 1e-9 * t.z());
  EXPECT_NEAR(t.x(), -3.0 / 0.01 / wall, 1e-9 * std::abs(t.x()));
  EXPECT_EQ(t.y(), 0.0);
}

// A rectangle a × b: two Gauss points per side integrate p × t exactly.
TEST(LinearTraction, ResultantOnARectangleIsTheWrench) {
  const double a = 0.04, b = 0.01;
  const Vector3d c(0.2, 0.1, -0.3);
  const Vector3d e_1 = Vector3d(1.0, 1.0, 0.2).normalized();
  const Vector3d e_2 = e_1.unitOrthogonal();
  const Vector3d e_3 = e_1.cross(e_2);
  const double I_1 = a * b * b * b / 12.0, I_2 = b * a * a * a / 12.0;
  const Matrix3d second = I_1 * e_1 * e_1.transpose() +
                          I_2 * e_2 * e_2.transpose() +
                          (I_1 + I_2) * e_3 * e_3.transpose();
  const Vector3d about(0.15, 0.2, -0.1);
  const LinearTraction load(c, a * b, second, kWrench, about);
  Wrench sum;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      const Vector3d p = c + 0.5 / std::sqrt(3.0) * (x * a * e_1 + y * b * e_2);
      const Vector3d force = 0.25 * a * b * load.traction(p);
      sum.force += force;
      sum.moment += (p - about).cross(force);
    }
  }
  expect_wrench(sum, kWrench, 0.1);
}

}  // namespace
}  // namespace clevis::loads
