#include "mesh/quality/mass_properties.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "unit/mesh/mesh_data.h"

namespace clevis::mesh {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
constexpr double kPi = std::numbers::pi;
constexpr double kDensity = 7850.0;

TEST(MassProperties, BoxIsExact) {
  for (const char* name : {"box_order_1.msh", "box_order_2.msh",
                           "box_order_4.msh", "box_serendipity.msh"}) {
    const auto got = mass_properties(read(name), kDensity);
    const double m = kDensity * 2e-9;
    EXPECT_NEAR(got.mass, m, 1e-14 * m);
    EXPECT_LT((got.p_LCm - Vector3d(1e-3, 0.5e-3, 0.5e-3)).norm(), 1e-17);
    const Matrix3d want =
        m / 12.0 * Vector3d(2e-6, 5e-6, 5e-6).asDiagonal().toDenseMatrix();
    EXPECT_LT((got.inertia_LCm - want).norm(), 1e-13 * want.norm()) << name;
  }
}

TEST(MassProperties, RingMatchesTheClosedForm) {
  const auto got = mass_properties(read("ring.msh"), kDensity);
  const double ri2 = 100e-6, ro2 = 400e-6, l = 6e-3;
  const double m = kDensity * kPi * (ro2 - ri2) * l;
  EXPECT_NEAR(got.mass, m, 1e-10 * m);
  EXPECT_LT((got.p_LCm - Vector3d(3e-3, 4e-3, 5e-3)).norm(), 1e-15);
  const double polar = 0.5 * m * (ro2 + ri2);
  const double across = m * (3.0 * (ro2 + ri2) + l * l) / 12.0;
  EXPECT_NEAR(got.inertia_LCm(2, 2), polar, 1e-10 * polar);
  EXPECT_NEAR(got.inertia_LCm(0, 0), across, 1e-10 * across);
  EXPECT_NEAR(got.inertia_LCm(1, 1), across, 1e-10 * across);
  EXPECT_LT(std::abs(got.inertia_LCm(0, 1)), 1e-12 * polar);
}

TEST(MassProperties, PlateWithBoreMatchesTheClosedForm) {
  const auto got = mass_properties(read("plate_with_bore_41.msh"), kDensity);
  const double a = 40e-3, r = 5e-3, t = 4e-3;
  const double m = kDensity * (a * a - kPi * r * r) * t;
  EXPECT_NEAR(got.mass, m, 1e-11 * m);
  EXPECT_LT((got.p_LCm - Vector3d(0.0, 0.0, 2e-3)).norm(), 1e-15);
  const double polar =
      kDensity * t * (std::pow(a, 4) / 6.0 - kPi * std::pow(r, 4) / 2.0);
  EXPECT_NEAR(got.inertia_LCm(2, 2), polar, 1e-11 * polar);
  const double across = 0.5 * polar + m * t * t / 12.0;
  EXPECT_NEAR(got.inertia_LCm(0, 0), across, 1e-11 * across);
}

TEST(MassProperties, UnitsScaleAsTheyShould) {
  const auto mm = mass_properties(read("ring.msh"), kDensity);
  const auto m =
      mass_properties(read_part_mesh(data("ring.msh"), 1.0), kDensity);
  EXPECT_NEAR(m.mass, 1e9 * mm.mass, 1e-12 * m.mass);
  EXPECT_LT((m.inertia_LCm - 1e15 * mm.inertia_LCm).norm(),
            1e-11 * m.inertia_LCm.norm());
}

TEST(FaceProperties, WallOfABore) {
  const PartMesh<3> mesh = read("ring.msh");
  const auto wall = face_properties(mesh, group_index(mesh, "bore_A"));
  const double r = 10e-3, l = 6e-3, area = 2.0 * kPi * r * l;
  EXPECT_NEAR(wall.area, area, 1e-10 * area);
  EXPECT_LT((wall.centroid - Vector3d(3e-3, 4e-3, 5e-3)).norm(), 1e-15);
  // ∫ (|r|² I - r rᵀ) dA of a thin tube.
  const double polar = area * r * r;
  const double across = area * (r * r / 2.0 + l * l / 12.0);
  const Matrix3d want =
      Vector3d(across, across, polar).asDiagonal().toDenseMatrix();
  EXPECT_LT((wall.second_moment - want).norm(), 1e-10 * want.norm());
}

TEST(FaceProperties, EndsOfARingAndSidesOfAPlate) {
  const PartMesh<3> ring = read("ring.msh");
  const auto ends = face_properties(ring, group_index(ring, "ends"));
  EXPECT_NEAR(ends.area, 2.0 * kPi * 300e-6, 1e-13);
  EXPECT_LT((ends.centroid - Vector3d(3e-3, 4e-3, 5e-3)).norm(), 1e-15);

  const PartMesh<3> plate = read("plate_with_bore_41.msh");
  const auto right = face_properties(plate, group_index(plate, "right"));
  EXPECT_NEAR(right.area, 160e-6, 1e-17);
  EXPECT_LT((right.centroid - Vector3d(20e-3, 0.0, 2e-3)).norm(), 1e-15);
  const auto unnamed = face_properties(plate, -1);
  EXPECT_NEAR(unnamed.area, 2 * 160e-6 + 1600e-6 - kPi * 25e-6, 1e-13);
}

TEST(FaceProperties, WallOfABoreInTetrahedra) {
  const PartMesh<3> mesh = read("ring_tetrahedra.msh");
  const auto wall = face_properties(mesh, group_index(mesh, "bore_A"));
  const double r = 10e-3, l = 6e-3, area = 2.0 * kPi * r * l;
  EXPECT_NEAR(wall.area, area, 1e-7 * area);
  EXPECT_LT((wall.centroid - Vector3d(3e-3, 4e-3, 5e-3)).norm(), 1e-10);
  EXPECT_NEAR(wall.second_moment(2, 2), area * r * r, 1e-7 * area * r * r);
  // Outward is towards the axis: a cell's own sense does not matter.
  EXPECT_LT(wall.area_vector.norm(), 1e-9 * area);
  const auto ends = face_properties(mesh, group_index(mesh, "ends"));
  EXPECT_LT(ends.area_vector.norm(), 1e-9 * area);
  EXPECT_NEAR(ends.area, 2.0 * kPi * 300e-6, 1e-7 * ends.area);
}

TEST(MassProperties, RingOfTetrahedraMatchesTheClosedForm) {
  const auto got = mass_properties(read("ring_tetrahedra.msh"), kDensity);
  const double ri2 = 100e-6, ro2 = 400e-6, l = 6e-3;
  const double m = kDensity * kPi * (ro2 - ri2) * l;
  const double polar = 0.5 * m * (ro2 + ri2);
  const double across = m * (3.0 * (ro2 + ri2) + l * l) / 12.0;
  EXPECT_NEAR(got.mass, m, 1e-7 * m);
  EXPECT_NEAR(got.inertia_LCm(2, 2), polar, 1e-7 * polar);
  EXPECT_NEAR(got.inertia_LCm(0, 0), across, 1e-7 * across);
}

}  // namespace
}  // namespace clevis::mesh
