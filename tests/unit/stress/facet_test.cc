#include "stress/corners/facet.h"

#include <numbers>

#include <gtest/gtest.h>

#include "support/annulus_mesh.h"

namespace clevis::stress {
namespace {

using std::numbers::pi;

TEST(Facet, OfACurveTellsItsKink) {
  const auto ring = support::ring_mesh<3>(
      {.inner = 0.005, .outer = 0.02, .radial = 3, .angular = 32, .degree = 1});
  const double kink = 2.0 * pi / 32.0;
  const Eigen::Matrix3d any = Eigen::Matrix3d::Zero();
  const Eigen::Vector3d inside(0.005, 0.0, 0.005);
  EXPECT_NEAR(facet_kink(ring, {}, inside, any), kink, 1e-9);
  EXPECT_EQ(facet_kink(ring, {}, {0.0095, 0.0, 0.005}, any), 0.0);
  // Hoop stress flows across the kinks, tension along the bore does not.
  Eigen::Matrix3d hoop = any, axial = any;
  hoop(1, 1) = 100e6;
  axial(2, 2) = 100e6;
  EXPECT_NEAR(facet_kink(ring, {}, inside, hoop), kink, 0.05 * kink);
  EXPECT_NEAR(facet_kink(ring, {}, inside, axial), 0.0, 1e-9);
  // A section that is turned has none round its axis.
  mesh::Revolution turned;
  turned.origin.setZero();
  turned.axes << Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX(),
      Eigen::Vector3d::UnitY();
  EXPECT_EQ(facet_kink(ring, {}, inside, hoop, &turned), 0.0);
}

}  // namespace
}  // namespace clevis::stress
