#include "numerics/factors/small_lu.h"

#include <cstdlib>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "numerics/factors/jacobian_factor.h"

namespace clevis::mechanism {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST(SmallLu, SolvesAsEigenDoes) {
  std::srand(7);
  for (const int n : {1, 2, 5, 18, 40}) {
    for (const double zeros : {0.0, 0.7}) {
      MatrixXd A = MatrixXd::Random(n, n);
      if (n > 1) A.diagonal().setZero();  // no pivot without exchange
      for (double& a : A.reshaped()) {
        if (std::rand() % 100 < 100.0 * zeros) a = 0.0;
      }
      A += MatrixXd::Identity(n, n).rowwise().reverse() * 2.0;
      const Eigen::FullPivLU<MatrixXd> reference(A);
      const VectorXd b = VectorXd::Random(n);
      numerics::SmallLu lu;
      lu.compute(A);
      ASSERT_NE(lu.determinant_sign(), 0);
      EXPECT_LT((A * lu.solve(b) - b).norm(), 1e-11);
      EXPECT_LT((A.transpose() * lu.solve_transposed(b) - b).norm(), 1e-11);
      EXPECT_EQ(lu.determinant_sign(), reference.determinant() > 0.0 ? 1 : -1);
    }
  }
}

TEST(SmallLu, SingularMatrixHasNoPivot) {
  MatrixXd A = MatrixXd::Random(6, 6);
  A.col(4) = A.col(1);
  numerics::SmallLu lu;
  lu.compute(A);
  EXPECT_LT(lu.smallest_pivot(), 1e-14 * lu.largest_pivot());
  A.col(2).setZero();
  lu.compute(A);
  EXPECT_EQ(lu.determinant_sign(), 0);
}

// Along a path of matrices whose smallest singular values cross, with the last
// factor as a first guess each time: never above twice the true value.
TEST(JacobianFactor, WeakestIsFollowedWhereSingularValuesCross) {
  std::srand(3);
  const MatrixXd U = MatrixXd::Random(8, 8).householderQr().householderQ();
  const MatrixXd V = MatrixXd::Random(8, 8).householderQr().householderQ();
  numerics::JacobianFactor last;
  for (int i = 0; i <= 100; ++i) {
    VectorXd s = VectorXd::Ones(8);
    s[3] = 0.2 + 0.003 * i;
    s[6] = 0.8 - 0.007 * i;
    numerics::JacobianFactor factor;
    factor.compute(U * s.asDiagonal() * V.transpose(),
                   i == 0 ? nullptr : &last);
    const double sigma = s.minCoeff();
    EXPECT_GE(factor.weakest().sigma, sigma * (1.0 - 1e-12));
    EXPECT_LT(factor.weakest().sigma, 1.3 * sigma) << i;
    last = factor;
  }
}

}  // namespace
}  // namespace clevis::mechanism
