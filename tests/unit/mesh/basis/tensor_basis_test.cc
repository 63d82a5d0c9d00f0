#include "mesh/basis/tensor_basis.h"

#include <cmath>

#include <gtest/gtest.h>

namespace clevis::mesh {
namespace {

constexpr double kRounding = 1e-14;

TEST(TensorBasis, GaussIntegratesMonomialsToDegree2nMinus1) {
  for (int n = 1; n <= 12; ++n) {
    const Quadrature rule = gauss(n);
    for (int degree = 0; degree < 2 * n; ++degree) {
      const double sum =
          rule.weights.dot(rule.points.array().pow(degree).matrix());
      EXPECT_NEAR(sum, 1.0 / (degree + 1), kRounding) << n << ' ' << degree;
    }
    const double beyond =
        rule.weights.dot(rule.points.array().pow(2 * n).matrix());
    if (n < 5) {
      EXPECT_GT(std::abs(beyond - 1.0 / (2 * n + 1)), 1e-8) << n;
    }
  }
}

TEST(TensorBasis, GaussLobattoPointsAreTabulated) {
  // Abramowitz and Stegun, table 25.6, moved to [0, 1].
  const auto third = gauss_lobatto(3), fourth = gauss_lobatto(4);
  EXPECT_NEAR(third[1], 0.5 * (1.0 - std::sqrt(1.0 / 5.0)), kRounding);
  EXPECT_NEAR(third[2], 0.5 * (1.0 + std::sqrt(1.0 / 5.0)), kRounding);
  EXPECT_NEAR(fourth[1], 0.5 * (1.0 - std::sqrt(3.0 / 7.0)), kRounding);
  EXPECT_NEAR(fourth[2], 0.5, kRounding);
  EXPECT_EQ(gauss_lobatto(1)[1], 1.0);
  EXPECT_NEAR(gauss_lobatto(2)[1], 0.5, kRounding);
}

TEST(TensorBasis, MapsAPolynomialWithItsGradient) {
  // x = s² + t, y = s t³ on degree 3.
  const Eigen::VectorXd nodes = gauss_lobatto(3);
  Eigen::Matrix2Xd points(2, 16);
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      const double s = nodes[i], t = nodes[j];
      points.col(i + 4 * j) << s * s + t, s * t * t * t;
    }
  }
  const Eigen::VectorXd at_s = Eigen::Vector2d(0.3, 0.9);
  const Eigen::VectorXd at_t = Eigen::Vector3d(0.1, 0.5, 0.7);
  const LagrangeBasis first = lagrange(nodes, at_s);
  const LagrangeBasis second = lagrange(nodes, at_t);
  const auto grid = map_grid<2>(points, {&first, &second});
  ASSERT_EQ(grid.points.cols(), 6);
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 2; ++i) {
      const double s = at_s[i], t = at_t[j];
      const int q = i + 2 * j;
      EXPECT_NEAR(grid.points(0, q), s * s + t, kRounding);
      EXPECT_NEAR(grid.points(1, q), s * t * t * t, kRounding);
      Eigen::Matrix2d J;
      J << 2.0 * s, 1.0, t * t * t, 3.0 * s * t * t;
      EXPECT_LT((grid.jacobian(q) - J).norm(), 8.0 * kRounding);
    }
  }
}

}  // namespace
}  // namespace clevis::mesh
