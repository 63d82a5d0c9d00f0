// Modes of small matrices against a dense solver and closed forms.

#include "dynamics/systems/eigenmodes.h"

#include <numbers>
#include <random>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "support/dense_system.h"

namespace clevis {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd positive_matrix(int n, unsigned seed) {
  std::srand(seed);
  const MatrixXd a = MatrixXd::Random(n, n);
  return a * a.transpose() + 0.1 * MatrixXd::Identity(n, n);
}

TEST(Eigenmodes, MatchADenseSolver) {
  const MatrixXd k = positive_matrix(80, 1);
  const MatrixXd m = positive_matrix(80, 2);
  const auto modes =
      dynamics::lowest_modes(support::dense_system(k, m), 12, "test");
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> dense(k, m);
  ASSERT_EQ(modes.squares.size(), 12);
  EXPECT_EQ(modes.rigid, 0);
  EXPECT_LT((modes.squares - dense.eigenvalues().head(12))
                .cwiseQuotient(dense.eigenvalues().head(12))
                .cwiseAbs()
                .maxCoeff(),
            1e-10);
  EXPECT_LT(
      (modes.shapes.transpose() * m * modes.shapes - MatrixXd::Identity(12, 12))
          .cwiseAbs()
          .maxCoeff(),
      1e-10);
}

/// An eigenvalue that occurs five times is found five times.
TEST(Eigenmodes, FindMultipleEigenvaluesAsOftenAsTheyOccur) {
  VectorXd values(60);
  for (int i = 0; i < 60; ++i) values[i] = i < 5 ? 2.0 : 3.0 + i;
  std::srand(3);
  const Eigen::HouseholderQR<MatrixXd> qr(MatrixXd::Random(60, 60));
  const MatrixXd q = qr.householderQ();
  const MatrixXd k = q * values.asDiagonal() * q.transpose();
  const auto modes = dynamics::lowest_modes(
      support::dense_system(k, MatrixXd::Identity(60, 60)), 7, "test");
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(modes.squares[i], 2.0, 1e-10);
  EXPECT_NEAR(modes.squares[5], 8.0, 1e-9);
  EXPECT_NEAR(modes.squares[6], 9.0, 1e-9);
}

/// Cantilever: β l = 1.875104 and 4.694091 of cos β l cosh β l = −1.
TEST(Eigenmodes, CantileverOfBeamElements) {
  const support::EulerBeam beam{1.0, 1.0, 1.0, 20};
  const auto modes = dynamics::lowest_modes(
      support::dense_system(support::without_first(beam.stiffness(), 2),
                            support::without_first(beam.mass(), 2)),
      2, "test");
  EXPECT_NEAR(std::sqrt(modes.squares[0]), 1.875104069 * 1.875104069, 1e-6);
  EXPECT_NEAR(std::sqrt(modes.squares[1]), 4.694091133 * 4.694091133, 1e-4);
}

/// Free-free: two rigid motions, exactly zero, then cos β l cosh β l = 1.
TEST(Eigenmodes, FreeBeamHasItsRigidMotionsFirst) {
  const support::EulerBeam beam{1.0, 1.0, 1.0, 20};
  auto system = support::dense_system(beam.stiffness(), beam.mass());
  system.rigid = MatrixXd::Zero(42, 2);
  for (int node = 0; node <= 20; ++node) {
    system.rigid(2 * node, 0) = 1.0;
    system.rigid(2 * node, 1) = node / 20.0;
    system.rigid(2 * node + 1, 1) = 1.0;
  }
  system.low_square = 1.0;
  const auto modes = dynamics::lowest_modes(system, 4, "test");
  EXPECT_EQ(modes.rigid, 2);
  EXPECT_EQ(modes.squares[0], 0.0);
  EXPECT_EQ(modes.squares[1], 0.0);
  EXPECT_NEAR(std::sqrt(modes.squares[2]), 4.730040745 * 4.730040745, 1e-4);
  EXPECT_LT(modes.residual.maxCoeff(), 1e-7);
}

}  // namespace
}  // namespace clevis
