#include "beam/estimates/struck_part.h"

#include <cmath>

#include <gtest/gtest.h>

#include "support/structured_mesh.h"

namespace clevis::beam {
namespace {

using Eigen::Vector3d;

constexpr double kLength = 0.2, kHeight = 0.02, kWidth = 0.01;
const part::Material kSteel{"steel", 210e9, 0.3, 7850.0, 355e6};

/// Along x; `tip` times as high at the far end.
mesh::PartMesh<3> bar(double tip = 1.0) {
  return support::structured_mesh<3>(
      {10, 2, 2}, 1, [=](const Vector3d& x) -> Vector3d {
        const double height = kHeight * (1.0 + (tip - 1.0) * x[0]);
        return {kLength * x[0], height * (x[1] - 0.5), kWidth * (x[2] - 0.5)};
      });
}

std::optional<BarOfPart> struck(const mesh::PartMesh<3>& mesh,
                                const Vector3d& direction) {
  return bar_of_part(mesh, kSteel, 0.3, Vector3d::Zero(),
                     Vector3d(kLength, 0.0, 0.0), direction);
}

TEST(BarOfPart, CantileverInEitherPlane) {
  const auto flat = struck(bar(), Vector3d::UnitZ());
  const auto high = struck(bar(), -Vector3d::UnitY());
  ASSERT_TRUE(flat && high);
  const double I = kWidth * std::pow(kHeight, 3) / 12.0;
  EXPECT_NEAR(high->bar.stiffness / (3.0 * 210e9 * I / std::pow(kLength, 3)),
              1.0, 1e-3);
  EXPECT_NEAR(high->bar.stress_per_force / (kLength * 0.5 * kHeight / I), 1.0,
              1e-3);
  EXPECT_NEAR(high->bar.stiffness / flat->bar.stiffness, 4.0, 4e-3);
  EXPECT_NEAR(high->bar.stiffness / high->published.stiffness, 3.0, 1e-12);
  EXPECT_EQ(high->bar.mass, 0.3);
  EXPECT_EQ(high->bar.mass_part, 33.0 / 140.0);
}

TEST(BarOfPart, RodAlongItsAxis) {
  const auto found = struck(bar(), -Vector3d::UnitX());
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->is_rod);
  EXPECT_NEAR(found->bar.stiffness / (210e9 * kHeight * kWidth / kLength), 1.0,
              1e-3);
}

TEST(BarOfPart, WhatIsNoBarIsNone) {
  EXPECT_FALSE(struck(bar(0.5), Vector3d::UnitZ()));  // tapers
  EXPECT_FALSE(struck(bar(), Vector3d(1.0, 1.0, 0.0).normalized()));
  EXPECT_FALSE(bar_of_part(bar(), kSteel, 0.3, Vector3d::Zero(),
                           Vector3d(0.03, 0.0, 0.0), Vector3d::UnitY()));
}

}  // namespace
}  // namespace clevis::beam
