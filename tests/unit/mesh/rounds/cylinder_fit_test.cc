#include "mesh/rounds/cylinder_fit.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "base/messages/errors.h"

namespace clevis::mesh {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// Two rings of points on an arc of a cylinder, and its facets' normals.
struct Arc {
  Matrix3Xd points, normals;
};

Arc arc(const part::Bore& bore, double span, int facets) {
  const Vector3d e1 = bore.axis_L.unitOrthogonal();
  const Vector3d e2 = bore.axis_L.cross(e1);
  Arc a{Matrix3Xd(3, 2 * (facets + 1)), Matrix3Xd(3, facets)};
  for (int i = 0; i <= facets; ++i) {
    const double angle = span * i / facets;
    const Vector3d ring =
        bore.p_LC + bore.radius * (std::cos(angle) * e1 + std::sin(angle) * e2);
    a.points.col(2 * i) = ring - 0.5 * bore.length * bore.axis_L;
    a.points.col(2 * i + 1) = ring + 0.5 * bore.length * bore.axis_L;
    const double middle = span * (i + 0.5) / facets;
    if (i < facets) {
      a.normals.col(i) = std::cos(middle) * e1 + std::sin(middle) * e2;
    }
  }
  return a;
}

const part::Bore kTilted{
    {0.3, -0.2, 0.1}, Vector3d(0.2, 0.5, 0.8).normalized(), 0.0125, 0.03};

TEST(CylinderFit, FindsAFullBoreToRounding) {
  const Arc a = arc(kTilted, 2.0 * std::numbers::pi * 7.0 / 8.0, 7);
  const CylinderFit fit = fit_cylinder(a.points, a.normals, "bore");
  EXPECT_NEAR(fit.bore.radius, kTilted.radius, 1e-12 * kTilted.radius);
  EXPECT_NEAR(fit.bore.length, kTilted.length, 1e-12);
  EXPECT_LT((fit.bore.p_LC - kTilted.p_LC).norm(), 1e-14);
  EXPECT_LT((fit.bore.axis_L - kTilted.axis_L).norm(), 1e-12);
  EXPECT_LT(fit.worst, 1e-12 * kTilted.radius);
}

TEST(CylinderFit, FindsAFilletOfTwoFacets) {
  const Arc a = arc(kTilted, 0.6, 2);
  const CylinderFit fit = fit_cylinder(a.points, a.normals, "round");
  EXPECT_NEAR(fit.bore.radius, kTilted.radius, 1e-11 * kTilted.radius);
  EXPECT_LT((fit.bore.p_LC - kTilted.p_LC).norm(), 1e-12);
}

TEST(CylinderFit, AnAxisAlongZIsExactlyThat) {
  const part::Bore upright{{0.14, 0.0, 0.0}, Vector3d::UnitZ(), 0.006, 0.01};
  Arc a = arc(upright, 5.0, 8);
  // What ten digits of a mesh file leave.
  for (int i = 0; i < a.points.cols(); ++i) a.points(0, i) += 1e-11 * (i % 3);
  const CylinderFit fit = fit_cylinder(a.points, a.normals, "bore");
  EXPECT_EQ(fit.bore.axis_L, Vector3d::UnitZ());
  EXPECT_NEAR(fit.bore.radius, upright.radius, 1e-10);
}

TEST(CylinderFit, SaysHowFarPointsAreOff) {
  Arc a = arc(kTilted, 5.0, 16);
  a.points.col(4) += 1e-5 * (a.points.col(4) - kTilted.p_LC).normalized();
  const CylinderFit fit = fit_cylinder(a.points, a.normals, "bore");
  EXPECT_GT(fit.worst, 0.5e-5 * 0.5);
  EXPECT_LT(fit.worst, 1e-5);
}

TEST(CylinderFit, RefusesAFlatFace) {
  const Arc a = arc(kTilted, 0.4, 1);
  try {
    fit_cylinder(a.points, a.normals, "part.msh, round_1");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "M009");
    EXPECT_EQ(error.place(), "part.msh, round_1");
  }
}

TEST(CylinderFit, ScrewLineHasEqualAngles) {
  const part::Bore unit{Vector3d::Zero(), Vector3d::UnitZ(), 1.0, 1.0};
  const Vector3d p(std::cos(3.0), std::sin(3.0), 0.0);
  const Vector3d q(std::cos(3.6), std::sin(3.6), 1.0);  // across ±π
  EXPECT_NEAR(angle_between(unit, p, q), 0.6, 1e-15);
  const Vector3d third = screw_line(unit, p, q, 1.0 / 3.0);
  EXPECT_LT((third - Vector3d(std::cos(3.2), std::sin(3.2), 1.0 / 3.0)).norm(),
            1e-15);
  EXPECT_LT((screw_line(unit, p, q, 1.0) - q).norm(), 1e-15);
}

}  // namespace
}  // namespace clevis::mesh
