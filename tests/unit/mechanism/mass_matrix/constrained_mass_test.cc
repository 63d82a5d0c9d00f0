#include "mechanism/mass_matrix/constrained_mass.h"

#include <cmath>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kColumns = 9, kRows = 4;

/// Numbers between −1 and 1, the same on every run.
MatrixXd numbers(Index rows, Index columns, double seed) {
  MatrixXd m(rows, columns);
  for (Index i = 0; i < m.size(); ++i) {
    const double x = 43758.5 * std::sin(seed + 12.9 * static_cast<double>(i));
    m.data()[i] = 2.0 * (x - std::floor(x)) - 1.0;
  }
  return m;
}

/// M of three blocks, two diagonal and one full, and its solver.
struct Blocks {
  Blocks() : mass(kColumns, kRows), M(MatrixXd::Zero(kColumns, kColumns)) {
    const Vector3d first(1.0, 0.5, 2.0), second(0.1, 3.0, 1.0);
    mass.set_diagonal(0, first);
    mass.set_diagonal(1, second);
    M.diagonal().head<3>() = first.cwiseAbs2().cwiseInverse();
    M.diagonal().segment<3>(3) = second.cwiseAbs2().cwiseInverse();
    const Matrix3d F =
        Matrix3d::Identity() + 0.3 * Matrix3d(numbers(3, 3, 0.4));
    mass.set_full(2, F, F.inverse());
    M.block<3, 3>(6, 6) = (F * F.transpose()).inverse();
  }

  ConstrainedMass mass;
  MatrixXd M;
};

TEST(ConstrainedMass, SolvesTheEquationsOfMotion) {
  Blocks blocks;
  const MatrixXd J = numbers(kRows, kColumns, 0.1);
  const VectorXd gamma = numbers(kRows, 1, 0.2), Q = numbers(kColumns, 1, 0.3);
  blocks.mass.factor(J, kRows);
  EXPECT_EQ(blocks.mass.rank(), kRows);
  VectorXd a = VectorXd::Zero(kColumns), lambda = VectorXd::Zero(kRows);
  blocks.mass.accelerate(gamma, Q, a, lambda);
  EXPECT_LT((blocks.M * a - Q - J.transpose() * lambda).norm(), 1e-12);
  EXPECT_LT((J * a - gamma).norm(), 1e-12);
  EXPECT_LT((blocks.mass.mass_times(a) - blocks.M * a).norm(), 1e-12);
}

// A row that repeats others leaves the motion as it is, and balance too.
TEST(ConstrainedMass, LeavesOutRowsThatDepend) {
  Blocks blocks;
  MatrixXd J = numbers(kRows, kColumns, 0.1);
  J.row(3) = 2.0 * J.row(0) - J.row(2);
  VectorXd gamma = numbers(kRows, 1, 0.2);
  gamma[3] = 2.0 * gamma[0] - gamma[2];
  const VectorXd Q = numbers(kColumns, 1, 0.3);
  blocks.mass.factor(J, kRows);
  EXPECT_EQ(blocks.mass.rank(), 3);
  VectorXd a = VectorXd::Zero(kColumns), lambda = VectorXd::Zero(kRows);
  blocks.mass.accelerate(gamma, Q, a, lambda);
  EXPECT_LT((J * a - gamma).norm(), 1e-10);
  EXPECT_LT((blocks.M * a - Q - J.transpose() * lambda).norm(), 1e-10);
}

// J change = −residual, and no other change of less mass norm: it is
// M-orthogonal to what the rows leave free.
TEST(ConstrainedMass, CorrectsByTheLeastMassNorm) {
  Blocks blocks;
  const MatrixXd J = numbers(kRows, kColumns, 0.6);
  const VectorXd residual = numbers(kRows, 1, 0.7);
  blocks.mass.factor(J, kRows);
  VectorXd change = VectorXd::Zero(kColumns);
  blocks.mass.correct(residual, change);
  EXPECT_LT((J * change + residual).norm(), 1e-12);
  const MatrixXd free = Eigen::FullPivLU<MatrixXd>(J).kernel();
  EXPECT_EQ(free.cols(), kColumns - kRows);
  EXPECT_LT((free.transpose() * blocks.M * change).norm(), 1e-11);
}

}  // namespace
}  // namespace clevis::mechanism
