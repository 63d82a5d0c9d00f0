#include "base/algebra/singular_vectors.h"

#include <gtest/gtest.h>

namespace clevis {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kRoundOff = 1e-13;

/// rows × columns of a rank, no entry special.
MatrixXd of_rank(Eigen::Index rows, Eigen::Index columns, Eigen::Index rank) {
  const auto scattered = [](Eigen::Index m, Eigen::Index n, double phase) {
    MatrixXd found(m, n);
    for (Eigen::Index i = 0; i < m; ++i) {
      for (Eigen::Index j = 0; j < n; ++j) {
        found(i, j) = std::sin(phase + 1.3 * static_cast<double>(i) +
                               2.7 * static_cast<double>(i * j + j));
      }
    }
    return found;
  };
  return scattered(rows, rank, 0.4) * scattered(rank, columns, 1.1);
}

void expect_orthonormal(const MatrixXd& columns) {
  const auto n = columns.cols();
  EXPECT_LT((columns.transpose() * columns - MatrixXd::Identity(n, n)).norm(),
            kRoundOff * 10);
}

// Small matrices, and those from 16 columns on.
TEST(SingularVectors, ProductIsTheMatrix) {
  for (const auto& [rows, columns] :
       {std::pair{3, 5}, std::pair{5, 3}, std::pair{30, 20}, {20, 30}}) {
    const MatrixXd A = of_rank(rows, columns, 3);
    const SingularVectors found = singular_vectors(A);
    expect_orthonormal(found.U);
    expect_orthonormal(found.V);
    MatrixXd sigma = MatrixXd::Zero(rows, columns);
    sigma.diagonal() = found.sigma;
    EXPECT_LT((found.U * sigma * found.V.transpose() - A).norm(),
              kRoundOff * A.norm() * 10);
    EXPECT_EQ(found.rank(1e-9), 3);
    EXPECT_LT((singular_values(A) - found.sigma).norm(),
              kRoundOff * A.norm() * 10);
  }
}

TEST(SingularVectors, SpacesHaveTheirDimensions) {
  for (const auto& [rows, columns] : {std::pair{4, 6}, std::pair{24, 18}}) {
    const MatrixXd A = of_rank(rows, columns, 2);
    const MatrixXd null = null_space(A, 1e-9), span = column_space(A, 1e-9);
    EXPECT_EQ(null.cols(), columns - 2);
    EXPECT_EQ(span.cols(), 2);
    expect_orthonormal(null);
    expect_orthonormal(span);
    EXPECT_LT((A * null).norm(), kRoundOff * A.norm() * 10);
    EXPECT_LT((A - span * (span.transpose() * A)).norm(),
              kRoundOff * A.norm() * 10);
    const SingularVectors found = singular_vectors(A);
    EXPECT_LT((found.left_rows(2).transpose() * A).norm(),
              kRoundOff * A.norm() * 10);
  }
}

TEST(SingularVectors, ZeroLeavesEverything) {
  EXPECT_EQ(null_space(MatrixXd::Zero(2, 3), 1e-9).cols(), 3);
  EXPECT_EQ(column_space(MatrixXd::Zero(2, 3), 1e-9).cols(), 0);
  EXPECT_EQ(null_space(MatrixXd(0, 3), 1e-9), MatrixXd::Identity(3, 3));
  EXPECT_EQ(null_space(MatrixXd(3, 0), 1e-9).cols(), 0);
  EXPECT_EQ(column_space(MatrixXd(3, 0), 1e-9).rows(), 3);
  EXPECT_EQ(singular_values(MatrixXd(3, 0)).size(), 0);
}

// 16 decades between two values of a small matrix.
TEST(SingularVectors, SmallValuesAreExactOfSmallMatrices) {
  const VectorXd wanted = VectorXd{{1.0, 1e-16}};
  const MatrixXd turn = MatrixXd{{0.6, -0.8}, {0.8, 0.6}};
  const VectorXd found = singular_values(turn * wanted.asDiagonal());
  EXPECT_NEAR(found[1] / 1e-16, 1.0, 1e-12);
}

}  // namespace
}  // namespace clevis
