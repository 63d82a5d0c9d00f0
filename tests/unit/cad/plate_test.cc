#include "cad/plate.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "solid_of_cylinders.h"

namespace clevis::cad {
namespace {

/// A plate of 100 x 100 x 10 mm with a bore.
Solid plate() {
  Solid solid = solid_of({
      plane_face(1, {0.05, 0, 0.005}, {0, 0, 1}),
      plane_face(2, {0, 0, 0}, {-1, 0, 0}),
      plane_face(3, {0.1, 0, 0}, {1, 0, 0}),
      plane_face(4, {0.05, -0.05, 0}, {0, -1, 0}),
      plane_face(5, {0.05, 0.05, 0}, {0, 1, 0}),
      plane_face(6, {0.05, 0, -0.005}, {0, 0, -1}),
      cylinder_face(7, 0.05, -0.005, 0.005, 0.012, true),
  });
  solid.low.z() = -0.005;
  solid.high.z() = 0.005;
  return solid;
}

TEST(Plate, HasOneProfileBetweenTwoPlanes) {
  const auto found = plate_of(plate());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->bottom, 6);
  EXPECT_EQ(found->top, 1);
  EXPECT_NEAR(found->thickness, 0.01, 1e-15);
}

/// The same, turned.
Solid turned(const Eigen::Matrix3d& turn) {
  Solid solid = plate();
  solid.faces[5].area = 0.01 - 1e-4;
  Eigen::AlignedBox3d box;
  for (int corner = 0; corner < 8; ++corner) {
    box.extend(turn * Eigen::AlignedBox3d(solid.low, solid.high)
                          .corner(static_cast<Eigen::AlignedBox3d::CornerType>(
                              corner)));
  }
  solid.low = box.min();
  solid.high = box.max();
  for (Face& face : solid.faces) {
    for (Eigen::Vector3d* v :
         {&face.centre, &face.normal, &face.axis_point, &face.axis}) {
      *v = turn * *v;
    }
  }
  return solid;
}

TEST(Plate, LiesInAnyDirection) {
  Eigen::Matrix3d to_x;  // z to x, x to y
  to_x << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  const auto along_x = plate_of(turned(to_x));
  ASSERT_TRUE(along_x);
  EXPECT_EQ(along_x->normal, Eigen::Vector3d::UnitX());
  EXPECT_EQ(along_x->bottom, 6);
  EXPECT_EQ(along_x->top, 1);
  EXPECT_NEAR(along_x->thickness, 0.01, 1e-15);
  EXPECT_EQ(text(*along_x), "a plate along x, 10 mm thick");
  const auto along_y = plate_of(turned(to_x * to_x));
  ASSERT_TRUE(along_y);
  EXPECT_EQ(along_y->normal, Eigen::Vector3d::UnitY());
  EXPECT_FALSE(along_y->is_along_z());
  const Eigen::Matrix3d skew =
      Eigen::AngleAxisd(0.6, Eigen::Vector3d(1, 2, 0.5).normalized())
          .toRotationMatrix();
  const auto slanted = plate_of(turned(skew));
  ASSERT_TRUE(slanted);
  EXPECT_LT((slanted->normal - skew.col(2)).norm(), 1e-12);
  EXPECT_EQ(slanted->bottom, 6);
  EXPECT_NEAR(slanted->thickness, 0.01, 1e-15);
  // Upside down the other face is the bottom.
  const auto below =
      plate_of(turned(Eigen::Vector3d(1, -1, -1).asDiagonal().toDenseMatrix()));
  ASSERT_TRUE(below);
  EXPECT_TRUE(below->is_along_z());
  EXPECT_EQ(below->bottom, 1);
}

TEST(Plate, HasNoOtherFaces) {
  Solid lying = plate();  // a bore along x
  lying.faces[6].axis = {1, 0, 0};
  EXPECT_FALSE(plate_of(lying));
  Solid slanted = plate();
  slanted.faces[2].normal = Eigen::Vector3d(1, 0, 0.01).normalized();
  EXPECT_FALSE(plate_of(slanted));
  Solid stepped = plate();  // a second face looks up, lower or beside
  stepped.faces.push_back(plane_face(8, {0.08, 0, 0.002}, {0, 0, 1}));
  EXPECT_FALSE(plate_of(stepped));
  stepped.faces.back().centre.z() = 0.005;
  EXPECT_FALSE(plate_of(stepped));
  Solid round = plate();
  round.faces[4].kind = SurfaceKind::kOther;
  EXPECT_FALSE(plate_of(round));
  Solid open = plate();
  open.faces.erase(open.faces.begin());
  EXPECT_FALSE(plate_of(open));
}

TEST(Plate, IsAtMostHalfAsThickAsWide) {
  Solid block = plate();
  block.low.y() = -0.009;
  block.high.y() = 0.009;
  EXPECT_FALSE(plate_of(block));
}

}  // namespace
}  // namespace clevis::cad
