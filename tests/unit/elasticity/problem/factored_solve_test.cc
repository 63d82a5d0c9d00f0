// Factors in single precision solve to the round-off of doubles, or doubles
// take their place.

#include "elasticity/problem/factored_solve.h"

#include <gtest/gtest.h>

#include "elasticity/assembly/equations.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/problem/single_precision.h"
#include "support/simplex_mesh.h"

namespace clevis::elasticity {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;

const part::Material kSteel{"steel", 210e9, 0.3, 7850.0, 355e6};

struct Bar {
  StiffnessMatrix<3> stiffness;
  EquationNumbers numbers;
  UpperTriangle matrix;
  FrontTree tree;
  MatrixXd multiply(const MatrixXd& x) const {
    return restrict_rows(stiffness.multiply(extend_rows(x, numbers)), numbers);
  }
};

/// Tetrahedra of a bar of 1 m x 1 m x a length, clamped at an end.
Bar bar(int cells, double length) {
  const auto mesh = support::simplex_mesh<3>(
      {cells, 2, 2}, 1, [&](const Vector3d& x) -> Vector3d {
        return {length * x[0], x[1], x[2] + 0.1 * x[0] * x[1]};
      });
  auto part = discretize<3>(mesh, 2);
  Bar result;
  const auto dissection = dissect(part);
  result.stiffness = assemble_stiffness<3>(part, kSteel, "bar");
  result.numbers = number_equations(
      part.dofs(), fixed_supports<3>(part, node_positions<3>(part),
                                     {{"x0", {true, true, true}}}, "bar"));
  result.matrix = free_equations(result.stiffness, result.numbers);
  result.tree = front_tree(dissection, 3, result.numbers.equation);
  return result;
}

FactoredSolution solved(const Bar& bar, const MatrixXd& b,
                        Precision precision) {
  return solve_by_factor(
      bar.matrix, bar.tree,
      [&](const MatrixXd& x) {
        return bar.multiply(x);
      },
      b, {precision, 1}, "part bar");
}

TEST(FactoredSolve, SinglePrecisionGivesTheDigitsOfDoubles) {
  const Bar compact = bar(4, 2.0);
  MatrixXd b = 1e5 * MatrixXd::Random(compact.matrix.rows(), 3);
  b.col(1).setZero();
  b.col(2) *= 1e-9;
  const auto expected = solved(compact, b, Precision::kDouble);
  const auto single = solved(compact, b, Precision::kSingle);
  for (const int column : {0, 2}) {
    EXPECT_LT((single.columns - expected.columns).col(column).norm(),
              1e-10 * expected.columns.col(column).norm());
  }
  EXPECT_EQ(single.columns.col(1).norm(), 0.0);
  // Its factor, which refinement goes on with, is the single one.
  const double off = (single.inverse(b) - expected.columns).col(0).norm();
  EXPECT_GT(off, 1e-9 * expected.columns.col(0).norm());
}

TEST(FactoredSolve, DoublesTakeThePlaceOfFloatsThatFail) {
  // Its stiffnesses differ by 1e11: in floats nothing is left of bending.
  const Bar slender = bar(160, 400.0);
  MatrixXd b = MatrixXd::Zero(slender.matrix.rows(), 1);
  b(b.rows() - 2, 0) = 1.0;
  const auto expected = solved(slender, b, Precision::kDouble);
  const auto single = solved(slender, b, Precision::kSingle);
  EXPECT_EQ(single.columns, expected.columns);
}

TEST(FactoredSolve, ConjugateGradientsGiveUp) {
  const Bar compact = bar(2, 2.0);
  const MatrixXd b = MatrixXd::Random(compact.matrix.rows(), 1);
  const auto multiply = [&](const MatrixXd& x) {
    return compact.multiply(x);
  };
  EXPECT_FALSE(solve_by_single_precision(
      multiply,
      [](const MatrixXd& x) {
        return x;  // no inverse at all
      },
      b));
}

TEST(FactoredSolve, FloatsAreForLargeFactorsAndFewColumns) {
  constexpr double kFlops = 1e12, kBytes = 2e9;
  EXPECT_EQ(cheaper_precision(kFlops, kBytes, 1.0), Precision::kSingle);
  EXPECT_EQ(cheaper_precision(kFlops, kBytes, 500.0), Precision::kDouble);
  EXPECT_EQ(cheaper_precision(1e9, 1e8, 1.0), Precision::kDouble);
}

}  // namespace
}  // namespace clevis::elasticity
