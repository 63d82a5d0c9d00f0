#include "stress/corners/round_depth.h"

#include <cmath>

#include <gtest/gtest.h>

#include "support/annulus_mesh.h"

namespace clevis::stress {
namespace {

using Eigen::Vector3d;

constexpr double kInner = 0.01, kOuter = 0.05;

double depth(int radial, const Vector3d& at) {
  return depth_over_radius(support::ring_mesh<3>({.inner = kInner,
                                                  .outer = kOuter,
                                                  .radial = radial,
                                                  .angular = 12,
                                                  .degree = 2}),
                           at);
}

// Cells of a ring from the bore outwards: their depth over the bore's radius.
TEST(RoundDepth, IsThatOfTheCellsAtTheBore) {
  const Vector3d at_bore(0.0, kInner, 0.0);
  for (const int radial : {1, 2}) {  // in geometric progression
    const double exact = std::pow(kOuter / kInner, 1.0 / radial) - 1.0;
    EXPECT_NEAR(depth(radial, at_bore), exact, 0.25 * exact) << radial;
  }
  EXPECT_LT(depth(8, at_bore), 0.8);  // as wide as they are along the bore
}

// The outer face is no hollow one, and the bore is far from it.
TEST(RoundDepth, OutsideNothingIsHollow) {
  EXPECT_EQ(depth(4, {kOuter, 0.0, 0.0}), 0.0);
}

}  // namespace
}  // namespace clevis::stress
