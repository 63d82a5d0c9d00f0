#include "stress/zones/end_of_shear.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "stress/zones/singular_zone.h"
#include "support/annulus_mesh.h"
#include "support/structured_mesh.h"

namespace clevis::stress {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

const part::Material kSteel{"steel", 210e9, 0.3, 7850.0, 355e6};
// √3 2/π a fold, from a tenth of the radius to a thousandth
const double kRise = std::sqrt(3.0) * 2.0 / pi * std::log(100.0);

mesh::PartMesh<3> block(std::array<int, 3> cells) {
  return support::structured_mesh<3>(cells, 1,
                                     [](const Vector3d& x) -> Vector3d {
                                       return 0.02 * x;
                                     });
}

loads::GroupShear even(const Vector3d& shear) {
  return {shear, Eigen::VectorXd::Zero(1)};
}

// Shear on a half of a side: on the smooth side its end rises like ln r; where
// both halves have the same nothing ends.
TEST(EndOfShear, IsAZoneOnASmoothSide) {
  auto mesh = block({4, 4, 4});
  mesh.groups.push_back({"half", {}});
  for (auto& face : mesh.boundary) {
    if (face.group == 2 && face.cell % 4 < 2) face.group = 6;
  }
  const Vector3d shear(0.0, 0.0, 3e6);
  const auto zones =
      singular_zones<3>(mesh, kSteel, {}, {{"half", even(shear)}});
  ASSERT_EQ(zones.size(), 1u);
  EXPECT_EQ(zones[0].name.substr(0, 24), "end of the shear on half");
  EXPECT_EQ(zones[0].exponent, 1.0);
  EXPECT_EQ(zones[0].edges.size(), 4u);
  EXPECT_NEAR(distance(zones[0], Vector3d(0.01, 0.0, 0.01)), 0.0, 1e-12);
  EXPECT_NEAR(zones[0].rise, 3e6 * kRise, 1e5);
  EXPECT_TRUE(singular_zones<3>(mesh, kSteel, {},
                                {{"half", even(shear)}, {"y0", even(shear)}})
                  .empty());
  const auto opposite = singular_zones<3>(
      mesh, kSteel, {}, {{"half", even(shear)}, {"y0", even(-shear)}});
  ASSERT_EQ(opposite.size(), 1u);
  EXPECT_NEAR(opposite[0].rise, 6e6 * kRise, 2e5);
  EXPECT_TRUE(singular_zones<3>(mesh, kSteel, {}, {}).empty());
}

// At an edge it is bounded: what points to the edge counts, unless the other
// face has as much.
TEST(EndOfShear, IsBoundedAtAnEdge) {
  const auto mesh = block({3, 3, 3});
  const Vector3d y(0.0, 3e6, 0.0), x(3e6, 0.0, 0.0), at(0.0, 0.0, 0.01);
  EXPECT_TRUE(singular_zones<3>(mesh, kSteel, {}, {{"x0", even(y)}}).empty());
  EXPECT_NEAR(rise_beside(sharp_ends(mesh, {{"x0", even(y)}}), at),
              3e6 * pi / 2.0, 1.0);
  EXPECT_NEAR(
      rise_beside(sharp_ends(mesh, {{"x0", even(y)}, {"y0", even(x)}}), at),
      0.0, 1.0);
  EXPECT_NEAR(
      rise_beside(sharp_ends(mesh, {{"x0", even(y)}, {"y0", even(-x)}}), at),
      3e6 * pi, 1.0);
  // along the edge, and far from any
  EXPECT_NEAR(
      rise_beside(sharp_ends(mesh, {{"x0", even(Vector3d(0.0, 0.0, 3e6))}}),
                  at),
      0.0, 1.0);
  EXPECT_EQ(rise_beside(sharp_ends(mesh, {{"x0", even(y)}}),
                        Vector3d(0.01, 0.01, 0.01)),
            0.0);
}

// What turns about the middle of a square face points to its edges the more the
// nearer it is to their ends; half-way it goes along them.
TEST(EndOfShear, TurningPointsToTheEdgesOfASquare) {
  constexpr double kSpin = 1e8;  // [Pa/m]
  const auto mesh = block({4, 4, 4});
  loads::GroupShear turning = even(Vector3d::Zero());
  turning.spin = kSpin * Vector3d::UnitX();
  turning.centre = {0.0, 0.01, 0.01};
  const auto ends = sharp_ends(mesh, {{"x0", turning}});
  EXPECT_EQ(ends.size(), 16u);
  for (const double z : {0.0, 0.0075, 0.01, 0.0125, 0.02}) {
    EXPECT_NEAR(rise_beside(ends, Vector3d(0.0, 0.0, z)),
                kSpin * std::abs(z - 0.01) * pi / 2.0, 1.0)
        << z;
  }
  EXPECT_NEAR(stress_at_corners(ends), 1.2 * kSpin * 0.02 * pi / 2.0, 1.0);
}

// On a round face it goes along the rim, however few its facets.
TEST(EndOfShear, TurningGoesAlongARim) {
  loads::GroupShear turning = even(Vector3d::Zero());
  turning.spin = 1e8 * Vector3d::UnitZ();
  const auto ring = support::ring_mesh<3>(
      {.inner = 0.005, .outer = 0.02, .radial = 2, .angular = 16, .degree = 2});
  const auto face = std::ranges::find_if(ring.groups, [](const auto& group) {
    return group.name.starts_with("z");
  });
  ASSERT_NE(face, ring.groups.end());
  const auto ends = sharp_ends(ring, {{face->name, turning}});
  EXPECT_GE(ends.size(), 16u);
  for (const auto& end : ends) {
    if (std::abs(end.at.head<2>().norm() - 0.02) > 1e-4) continue;
    EXPECT_LT(rise_beside({end}, end.at), 1e-6 * 1e8 * 0.02)
        << end.at.transpose();
  }
}

// A roller mirrors shear that runs towards it: twice as much ends there. What
// runs along it goes on behind it.
TEST(EndOfShear, IsMirroredByARoller) {
  const auto mesh = block({3, 3, 3});
  const part::Supports roller = {{"x0", {true, false, false}}};
  const auto zones = singular_zones<3>(
      mesh, kSteel, roller, {{"y0", even(Vector3d(-3e6, 0.0, 1e6))}});
  ASSERT_EQ(zones.size(), 1u);
  EXPECT_EQ(zones[0].exponent, 1.0);
  EXPECT_EQ(zones[0].edges.size(), 3u);
  EXPECT_NEAR(distance(zones[0], Vector3d(0.0, 0.0, 0.01)), 0.0, 1e-12);
  EXPECT_NEAR(zones[0].rise, 6e6 * kRise, 2e5);
  EXPECT_TRUE(singular_zones<3>(mesh, kSteel, roller,
                                {{"y0", even(Vector3d(0.0, 0.0, 3e6))}})
                  .empty());
}

}  // namespace
}  // namespace clevis::stress
