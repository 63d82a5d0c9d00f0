#include "cad/plate.h"

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
