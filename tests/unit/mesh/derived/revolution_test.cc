#include "mesh/derived/revolution.h"

#include <array>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/annulus_mesh.h"

namespace clevis::mesh {
namespace {

using Eigen::Vector3d;

const support::Annulus kRing{.inner = 0.02,
                             .outer = 0.05,
                             .thickness = 0.03,
                             .start = 0.4,
                             .radial = 3,
                             .angular = 8,
                             .axial = 2,
                             .degree = 2};

/// The same part turned and moved.
PartMesh<3> placed(PartMesh<3> mesh, const Eigen::Isometry3d& pose) {
  for (auto& vertex : mesh.vertices) vertex = pose * vertex;
  for (auto& points : mesh.cell_points) points = (pose * points).eval();
  for (auto& group : mesh.groups) {
    if (!group.cylinder) continue;
    group.cylinder->p_LC = pose * group.cylinder->p_LC;
    group.cylinder->axis_L = pose.linear() * group.cylinder->axis_L;
  }
  return mesh;
}

/// Every meridian point turned by the sectors' angles is a point of the part.
TEST(Revolution, FoundAboutASkewAxisThatACylinderNames) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translate(Vector3d(0.1, -0.2, 0.05));
  pose.rotate(Eigen::AngleAxisd(0.8, Vector3d(1, 2, -1).normalized()));
  const auto mesh = placed(support::ring_mesh<3>(kRing), pose);
  const auto solid = find_revolution(mesh);
  ASSERT_TRUE(solid);
  EXPECT_EQ(solid->meridian.cells.size(), 6U);
  EXPECT_EQ(solid->meridian.vertices.size(), 12U);
  EXPECT_NEAR(std::abs(solid->axes.col(0).dot(pose.linear().col(2))), 1.0,
              1e-12);
  EXPECT_NEAR(solid->axes.determinant(), 1.0, 1e-12);
  double worst = 0.0;
  for (const auto& vertex : solid->meridian.vertices) {
    double nearest = 1.0;
    for (int k = 0; k < 720; ++k) {
      const Vector3d at = solid->at(vertex, k * 0.01);
      for (const auto& p : mesh.vertices) {
        nearest = std::min(nearest, (p - at).norm());
      }
    }
    worst = std::max(worst, nearest);
  }
  EXPECT_LT(worst, 0.01 * 0.05);
}

TEST(Revolution, GroupsAreThoseOfTheRings) {
  auto mesh = support::ring_mesh<3>(kRing);
  const auto solid = find_revolution(mesh);
  ASSERT_TRUE(solid);
  EXPECT_EQ(solid->axes.col(0), Vector3d::UnitZ());
  std::array<int, 6> faces{};
  for (const auto& face : solid->meridian.boundary) {
    ++faces[std::size_t(face.group)];
  }
  EXPECT_EQ(faces, (std::array<int, 6>{2, 2, 0, 0, 3, 3}));
  // A group on a part of a ring cannot be told in the meridian.
  mesh.boundary.front().group = 4;
  EXPECT_FALSE(find_revolution(mesh));
}

TEST(Revolution, OtherPartsAreNone) {
  EXPECT_FALSE(find_revolution(support::sector_mesh<3>(kRing)));
  auto faceted = kRing;
  faceted.degree = 1;
  EXPECT_FALSE(find_revolution(support::ring_mesh<3>(faceted)));
  auto dented = support::ring_mesh<3>(kRing);
  dented.cell_points[0].col(0) *= 1.0 + 1e-6;
  EXPECT_FALSE(find_revolution(dented));
  const auto block = support::structured_mesh<3>(
      {2, 2, 2}, 2, [](const Vector3d& x) -> Vector3d {
        return 0.1 * x;
      });
  EXPECT_FALSE(find_revolution(block));
}

}  // namespace
}  // namespace clevis::mesh
