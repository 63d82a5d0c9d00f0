#include "loads/pressure/discrete_balance.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace clevis::loads {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

const part::Bore kBore{.p_LC = {0.06, 0.02, 0.0},
                       .axis_L = Vector3d::UnitZ(),
                       .radius = 7.5e-3,
                       .length = 5e-3};
const Wrench kWrench{.force = {820.0, -410.0, 30.0},
                     .moment = {0.4, -0.3, 0.8}};

// A coarse midpoint rule on the wall, blind to the kink.
GroupQuadrature coarse_wall(int around, int along) {
  GroupQuadrature q;
  q.points.resize(3, around * along);
  q.weights.resize(around * along);
  const double dA =
      2.0 * std::numbers::pi * kBore.radius * kBore.length / (around * along);
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < along; ++j) {
      const double theta = 2.0 * std::numbers::pi * (i + 0.3) / around;
      q.points.col(i * along + j) =
          kBore.p_LC + Vector3d(kBore.radius * std::cos(theta),
                                kBore.radius * std::sin(theta),
                                kBore.length * ((j + 0.5) / along - 0.5));
      q.weights[i * along + j] = dA;
    }
  }
  return q;
}

Matrix3Xd bearing_tractions(const GroupQuadrature& q) {
  const BearingTraction load(kBore, kWrench);
  Matrix3Xd t(3, q.points.cols());
  for (Index i = 0; i < t.cols(); ++i) {
    const Vector3d p = q.points.col(i);
    Vector3d inward = kBore.p_LC - p;
    inward.z() = 0.0;
    t.col(i) = load.traction(p, inward.normalized());
  }
  return t;
}

Matrix3Xd corrected(const GroupQuadrature& q, const Matrix3Xd& tractions,
                    const Wrench& wrench, const Vector3d& about) {
  const LinearTraction rest =
      DiscreteBalance(q, about).missing(wrench, tractions);
  Matrix3Xd t = tractions;
  for (Index i = 0; i < t.cols(); ++i) {
    t.col(i) += rest.traction(q.points.col(i));
  }
  return t;
}

TEST(DiscreteBalance, CorrectedTractionsSumToTheWrench) {
  const GroupQuadrature q = coarse_wall(9, 3);
  const Matrix3Xd raw = bearing_tractions(q);
  const Wrench before = resultant(q, raw, kBore.p_LC);
  ASSERT_GT((before.force - kWrench.force).norm(), 1e-4 * kWrench.force.norm())
      << "the rule is too good to test anything";
  const Wrench after =
      resultant(q, corrected(q, raw, kWrench, kBore.p_LC), kBore.p_LC);
  EXPECT_LT((after.force - kWrench.force).norm(), 1e-12 * kWrench.force.norm());
  EXPECT_LT((after.moment - kWrench.moment).norm(),
            1e-12 * kWrench.moment.norm());
}

TEST(DiscreteBalance, ReferencePointMayLieAnywhere) {
  const GroupQuadrature q = coarse_wall(9, 3);
  const Matrix3Xd raw = bearing_tractions(q);
  const Vector3d about(-0.1, 0.3, 0.2);
  const Wrench shifted{
      .force = kWrench.force,
      .moment = kWrench.moment + (kBore.p_LC - about).cross(kWrench.force)};
  const Matrix3Xd a = corrected(q, raw, kWrench, kBore.p_LC);
  const Matrix3Xd b = corrected(q, raw, shifted, about);
  // Moments about a point 0.4 m away lose (0.4 m / 7.5 mm)² digits.
  EXPECT_LT((a - b).norm(), 1e-12 * 3e3 * a.norm());
}

TEST(DiscreteBalance, NothingIsAddedToWhatFits) {
  const GroupQuadrature q = coarse_wall(9, 3);
  const Matrix3Xd raw = bearing_tractions(q);
  const Wrench own = resultant(q, raw, kBore.p_LC);
  const Matrix3Xd same = corrected(q, raw, own, kBore.p_LC);
  EXPECT_LT((same - raw).norm(), 1e-13 * raw.norm());
}

// A straight edge of a plane model: no second moment about its own line.
TEST(DiscreteBalance, StraightEdgeInItsPlane) {
  GroupQuadrature q;
  q.points.resize(3, 4);
  q.points << 0.0, 0.01, 0.03, 0.04,  //
      0.1, 0.1, 0.1, 0.1,             //
      0.0, 0.0, 0.0, 0.0;
  q.weights = Eigen::Vector4d(1e-5, 2e-5, 2e-5, 1e-5);
  const Wrench wanted{.force = {5.0, -7.0, 0.0}, .moment = {0.0, 0.0, 0.2}};
  const Vector3d about(0.02, 0.1, 0.0);
  const Matrix3Xd t = corrected(q, Matrix3Xd::Zero(3, 4), wanted, about);
  ASSERT_TRUE(t.allFinite());
  const Wrench got = resultant(q, t, about);
  EXPECT_LT((got.force - wanted.force).norm(), 1e-12 * wanted.force.norm());
  EXPECT_LT((got.moment - wanted.moment).norm(), 1e-12 * wanted.moment.norm());
}

}  // namespace
}  // namespace clevis::loads
