#include "cad/first_case.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "solid_of_cylinders.h"

namespace clevis::cad {
namespace {

using Eigen::Vector3d;

constexpr double kRoundOff = 1e-12;

/// A bore that goes all round, about an axis through a point.
Face bore(int number, const Vector3d& middle, const Vector3d& axis,
          double diameter, double length = 0.01) {
  Face face =
      cylinder_face(number, 0.0, -length / 2, length / 2, diameter, true);
  face.axis_point = middle;
  face.axis = axis.normalized();
  face.centre = middle;
  face.normal_square =
      face.area / 2 *
      (Eigen::Matrix3d::Identity() - face.axis * face.axis.transpose());
  return face;
}

Face plane(int number, const Vector3d& centre, const Vector3d& normal,
           double area) {
  Face face = plane_face(number, centre, normal);
  face.area = area;
  return face;
}

TEST(PinBores, WidestFirstThenByPlace) {
  const Vector3d z = Vector3d::UnitZ();
  const Solid solid = solid_of(
      {bore(1, {0.02, 0, 0}, z, 0.006), bore(2, {0.09, 0, 0}, z, 0.01),
       bore(3, {0.01, 0, 0}, z, 0.01), bore(4, {0.01, 0.03, 0}, z, 0.01),
       cylinder_face(5, 0.05, 0.0, 0.01, 0.03, false),
       cylinder_face(6, 0.07, 0.0, 0.01, 0.02, true, std::numbers::pi)});
  std::vector<int> order;
  for (const PinBore& one : pin_bores(solid)) {
    order.push_back(one.faces().front());
  }
  EXPECT_EQ(order, (std::vector{3, 4, 2, 1}));  // no shaft, no half bore
}

/// What a cross bore or a saddle takes of the wall of a face.
Face less(Face face, double share, double even = 1.0) {
  face.area *= share;
  face.normal_square *= share;
  face.normal_square(0, 0) *= even;
  face.normal_square(1, 1) *= 2.0 - even;
  return face;
}

TEST(PinBores, WallsThatDoNotCloseAboutAPinAreOpen) {
  const Vector3d z = Vector3d::UnitZ();
  const auto open_among = [](std::vector<Face> faces) {
    std::vector<int> open;
    const Solid solid = solid_of(std::move(faces));
    for (const PinBore& one : open_bores(solid)) {
      open.push_back(one.faces().front());
    }
    EXPECT_EQ(open.size() + pin_bores(solid).size(), solid.faces.size());
    return open;
  };
  // Keyways of 3 % and 14 %, a slot of a quarter.
  const double turn = 2 * std::numbers::pi;
  EXPECT_EQ(
      open_among({cylinder_face(1, 0.0, 0.0, 0.01, 0.02, true, 0.97 * turn),
                  cylinder_face(2, 0.03, 0.0, 0.01, 0.02, true, 0.86 * turn),
                  cylinder_face(3, 0.06, 0.0, 0.01, 0.02, true, 0.75 * turn)}),
      std::vector{3});
  // Cross bores and sloped ends take some of a wall, too.
  EXPECT_EQ(open_among({less(bore(1, {0, 0, 0}, z, 0.02), 0.89),
                        less(bore(2, {0.03, 0, 0}, z, 0.02), 0.95, 1.05),
                        less(bore(3, {0.06, 0, 0}, z, 0.02), 0.55)}),
            std::vector{3});
}

TEST(PinBores, ConcaveFilletsAndTipsOfTeethAreNone) {
  const double pi = std::numbers::pi;
  std::vector<Face> teeth{cylinder_face(1, 0.05, 0.0, 0.01, 0.02, true, pi)};
  for (int k = 0; k < 10; ++k) {  // half of the turn, alike on all sides
    Face tip = cylinder_face(2 + k, 0.0, 0.0, 0.01, 0.03, true, pi / 10);
    tip.centre = {0.015 * std::cos(k * pi / 5), 0.015 * std::sin(k * pi / 5),
                  0.005};
    teeth.push_back(tip);
  }
  EXPECT_TRUE(pin_bores(solid_of(teeth)).empty());
  EXPECT_TRUE(open_bores(solid_of(teeth)).empty());
}

TEST(PinBores, EarsAreOneBoreAndACounterboreIsNone) {
  const Vector3d z = Vector3d::UnitZ();
  const Solid solid =
      solid_of({bore(1, {0, 0, -0.02}, z, 0.01), bore(2, {0, 0, 0.03}, z, 0.01),
                bore(3, {0.05, 0, 0}, z, 0.01, 0.02),
                bore(4, {0.05, 0, 0.012}, z, 0.018, 0.004)});
  const auto bores = pin_bores(solid);
  ASSERT_EQ(bores.size(), 2u);
  EXPECT_EQ(bores[0].faces(), (std::vector{1, 2}));
  EXPECT_NEAR(bores[0].length, 0.02, kRoundOff);
  EXPECT_NEAR(bores[0].middle.z(), 0.005, kRoundOff);
  EXPECT_EQ(bores[1].faces(), std::vector{3});
}

/// Across the pulled bore, no moment about the axis of the held one.
void expect_held(const FirstCase& made) {
  ASSERT_TRUE(made.held && made.pulled);
  const PinBore& held = made.bores[*made.held];
  const PinBore& pulled = made.bores[*made.pulled];
  EXPECT_NEAR(made.direction.norm(), 1.0, kRoundOff);
  const Vector3d moment = (pulled.middle - held.middle).cross(made.direction);
  EXPECT_NEAR(moment.dot(held.axis), 0.0, kRoundOff);
  EXPECT_LE(std::abs(made.direction.dot(pulled.axis)), 0.02);
}

TEST(FirstCase, PullsOneBoreAwayFromAnother) {
  const Vector3d z = Vector3d::UnitZ();
  const auto made =
      first_case(solid_of({bore(1, {0, 0, 0}, z, 0.02),
                           bore(2, {0.06, 0.08, 0.001}, z, 0.01)}),
                 "part.step");
  expect_held(made);
  EXPECT_EQ(made.bores[*made.held].faces(), std::vector{1});
  EXPECT_NEAR((made.direction - Vector3d(0.6, 0.8, 0)).norm(), 0.0, kRoundOff);
  EXPECT_FALSE(made.base);
}

TEST(FirstCase, NoMomentHoweverTheAxesLie) {
  // Parallel, crossed, crossing, skew, nearly normal, along the way between.
  const Vector3d a{0.3, -0.5, 0.8};
  for (const Vector3d& b :
       {a, Vector3d(0.5, 0.3, 0), Vector3d(0, 1, 0), Vector3d(0.2, 0.9, 0.4),
        Vector3d(0.01, 1, 0.02), Vector3d(1, 0, 0)}) {
    expect_held(first_case(
        solid_of({bore(1, {0, 0, 0}, a, 0.02), bore(2, {0.07, 0, 0}, b, 0.01)}),
        "part.step"));
  }
  // Both middles in one point.
  expect_held(first_case(solid_of({bore(1, {0, 0, 0}, a, 0.02),
                                   bore(2, {0, 0, 0}, {0.5, 0.3, 0}, 0.01)}),
                         "part.step"));
}

TEST(FirstCase, OneBoreIsPulledOffThePlaneFarthestBehind) {
  const auto made =
      first_case(solid_of({bore(1, {0.08, 0, 0}, Vector3d::UnitZ(), 0.01),
                           plane(2, {0, 0, 0}, -Vector3d::UnitX(), 4e-4),
                           plane(3, {0.04, 0.01, 0}, Vector3d::UnitY(), 9e-4),
                           plane(4, {0.04, 0, 0.005}, Vector3d::UnitZ(), 1.0)}),
                 "part.step");
  EXPECT_FALSE(made.held);
  EXPECT_EQ(made.base, 2);
  EXPECT_EQ(made.pulled, 0u);
  EXPECT_NEAR((made.direction - Vector3d::UnitX()).norm(), 0.0, kRoundOff);
}

TEST(FirstCase, BoltsStandForTheFaceThatTheyHold) {
  const Vector3d z = Vector3d::UnitZ();
  std::vector<Face> faces{bore(1, {0, 0, 0.05}, Vector3d::UnitX(), 0.02),
                          plane(2, {0, 0, 0}, -z, 4e-3),
                          plane(3, {0, 0.05, 0.03}, Vector3d::UnitY(), 1e-1)};
  faces.push_back(bore(4, {-0.04, 0, 0.005}, z, 0.008));
  auto made = first_case(solid_of(faces), "part.step");
  EXPECT_TRUE(made.held);  // one bolt is a pin
  faces.push_back(bore(5, {0.04, 0, 0.005}, z, 0.008));
  made = first_case(solid_of(faces), "part.step");
  EXPECT_EQ(made.base, 2);
  EXPECT_EQ(made.pulled, 0u);
  EXPECT_NEAR((made.direction - z).norm(), 0.0, kRoundOff);
}

TEST(FirstCase, WithoutBoresTheEndsArePulledApart) {
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY();
  const auto made = first_case(
      solid_of({plane(1, {0, 0, 0}, -x, 1e-4), plane(2, {0.1, 0, 0}, x, 1e-4),
                plane(3, {0, -0.005, 0}, -y, 1e-3),
                plane(4, {0, 0.005, 0}, y, 1e-3)}),
      "part.step");
  EXPECT_EQ(made.base, 1);
  EXPECT_EQ(made.end, 2);
  EXPECT_NEAR((made.direction - x).norm(), 0.0, kRoundOff);
}

TEST(FirstCase, RefusesWhatShowsNothing) {
  try {
    first_case(solid_of({cylinder_face(1, 0.0, 0.0, 0.01, 0.03, false)}),
               "ball.step");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "M017");
    EXPECT_EQ(error.place(), "ball.step");
    EXPECT_NE(error.problem().find("no bore"), std::string::npos);
  }
}

}  // namespace
}  // namespace clevis::cad
