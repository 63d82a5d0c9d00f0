#include "loads/pressure/face_pressure.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace clevis::loads {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using std::numbers::pi;

/// Of a sphere of radius 1 about the origin, from the pole z = 1 to a polar
/// angle; normals are the points themselves.
GroupQuadrature cap(double angle) {
  constexpr int kRings = 200, kAround = 40;
  GroupQuadrature cap;
  cap.points.resize(3, kRings * kAround);
  cap.weights.resize(kRings * kAround);
  for (int i = 0; i < kRings; ++i) {
    const double a = angle * (i + 0.5) / kRings;
    for (int k = 0; k < kAround; ++k) {
      const double b = 2.0 * pi * k / kAround;
      const int q = i * kAround + k;
      cap.points.col(q) = Vector3d(std::sin(a) * std::cos(b),
                                   std::sin(a) * std::sin(b), std::cos(a));
      cap.weights[q] = std::sin(a) * angle / kRings * 2.0 * pi / kAround;
    }
  }
  return cap;
}

// p = F / (π sin² angle), whatever the force's other components.
TEST(FacePressure, OfADomeIsForceOverProjectedArea) {
  const double angle = 1.1;
  const GroupQuadrature dome = cap(angle);
  const Matrix3Xd found =
      face_pressure(dome, dome.points, {30.0, 20.0, -500.0});
  const double pressure = 500.0 / (pi * std::pow(std::sin(angle), 2));
  EXPECT_LT((found + pressure * dome.points).cwiseAbs().maxCoeff(),
            1e-4 * pressure);
}

TEST(FacePressure, OfFlatAndClosedFacesIsNone) {
  GroupQuadrature flat = cap(1.0);
  flat.points.row(2).setZero();
  const Matrix3Xd up = Vector3d::UnitZ().replicate(1, flat.points.cols());
  EXPECT_TRUE(face_pressure(flat, up, {0.0, 0.0, 9.0}).isZero(0.0));
  const GroupQuadrature sphere = cap(pi);
  EXPECT_TRUE(
      face_pressure(sphere, sphere.points, {0.0, 0.0, 9.0}).isZero(0.0));
}

}  // namespace
}  // namespace clevis::loads
