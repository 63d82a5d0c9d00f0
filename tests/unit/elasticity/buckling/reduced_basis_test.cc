#include "elasticity/buckling/reduced_basis.h"

#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kEquations = 30;

MatrixXd numbers(Index rows, Index columns, double seed) {
  MatrixXd matrix(rows, columns);
  for (Index k = 0; k < matrix.size(); ++k) {
    matrix.data()[k] = std::sin(seed + 1.7 * static_cast<double>(k * k % 1009));
  }
  return matrix;
}

/// Symmetric, its eigenvalues within ±1.
MatrixXd term(double seed) {
  const MatrixXd any = numbers(kEquations, kEquations, seed);
  const MatrixXd symmetric = any + any.transpose();
  return symmetric / symmetric.operatorNorm();
}

/// Two terms and what acts through three motions C y, with gains.
struct Known {
  Known() : basis(sources) {
    const MatrixXd vectors = basis.beside(numbers(kEquations, 4, 0.3));
    basis.append(vectors, {});
    basis.append_term(first * basis.vectors());
    basis.append_term(second * basis.vectors());
  }
  MatrixXd whole(double a, double b, double gain) const {
    return a * first + b * second + gain * sources * sources.transpose();
  }
  ReducedBasis::Action action(double a, double b, double gain) const {
    return {Eigen::Vector2d(a, b),
            gain * sources.transpose() * basis.vectors()};
  }
  void append(const MatrixXd& columns) {
    const MatrixXd vectors = basis.beside(columns);
    basis.append(vectors, {first * vectors, second * vectors});
  }

  MatrixXd first = term(1.0), second = term(2.0);
  MatrixXd sources = 0.1 * numbers(kEquations, 3, 0.7);
  ReducedBasis basis;
};

// Whether b lies in the basis or not.
TEST(ReducedBasis, ResidualIsThatOfAllEquations) {
  const Known known;
  const MatrixXd a = known.whole(0.4, -0.3, 0.5);
  const auto action = known.action(0.4, -0.3, 0.5);
  for (const VectorXd& b :
       {VectorXd(known.basis.vectors() * Eigen::Vector4d(1, 2, 3, 4)),
        VectorXd(numbers(kEquations, 1, 5.0))}) {
    const auto solution = known.basis.solve(action, b);
    ASSERT_TRUE(solution.is_stable);
    const VectorXd y = known.basis.vectors() * solution.amounts;
    const VectorXd residual = b - y + a * y;
    EXPECT_NEAR(solution.residual, residual.norm(), 1e-7 * b.norm());
    EXPECT_LT(
        (known.basis.residual(action, b, solution.amounts) - residual).norm(),
        1e-12 * b.norm());
    EXPECT_LT((known.basis.vectors().transpose() * residual).norm(),
              1e-12 * b.norm());
    EXPECT_GT(residual.norm(), 0.01 * b.norm());
  }
}

TEST(ReducedBasis, SolvesWhatItHasSeen) {
  Known known;
  const MatrixXd a = known.whole(0.4, -0.3, 0.5);
  const VectorXd b = known.basis.vectors().col(2);
  const VectorXd y =
      (MatrixXd::Identity(kEquations, kEquations) - a).llt().solve(b);
  known.append(y);
  EXPECT_EQ(known.basis.size(), 5);
  EXPECT_EQ(known.basis.beside(y).cols(), 0);
  const auto solution = known.basis.solve(known.action(0.4, -0.3, 0.5), b);
  ASSERT_TRUE(solution.is_stable);
  EXPECT_LT(solution.residual, 1e-7 * b.norm());
  EXPECT_LT((known.basis.vectors() * solution.amounts - y).norm(),
            1e-10 * y.norm());
}

// Where memory ends it starts anew: no vector, and all of b is left.
TEST(ReducedBasis, ClearedItKeepsItsTermsAndSources) {
  Known known;
  const VectorXd b = known.basis.vectors().col(2);
  known.basis.clear();
  EXPECT_EQ(known.basis.size(), 0);
  const auto none = known.basis.solve(known.action(0.4, -0.3, 0.5), b);
  ASSERT_TRUE(none.is_stable);
  EXPECT_NEAR(none.residual, b.norm(), 1e-12);
  known.append(b);
  const auto solution = known.basis.solve(known.action(0.4, -0.3, 0.5), b);
  ASSERT_TRUE(solution.is_stable);
  const VectorXd y = known.basis.vectors() * solution.amounts;
  const VectorXd residual = b - y + known.whole(0.4, -0.3, 0.5) * y;
  EXPECT_NEAR(solution.residual, residual.norm(), 1e-7);
}

TEST(ReducedBasis, ShapeWithoutStiffnessIsFoundInIt) {
  Known known;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> modes(known.first);
  known.append(modes.eigenvectors().rightCols<1>());
  const double largest = modes.eigenvalues()[kEquations - 1];
  const VectorXd b = known.basis.vectors().col(0);
  EXPECT_TRUE(
      known.basis.solve(known.action(0.999 / largest, 0.0, 0.0), b).is_stable);
  EXPECT_FALSE(
      known.basis.solve(known.action(1.001 / largest, 0.0, 0.0), b).is_stable);
}

}  // namespace
}  // namespace clevis::elasticity
