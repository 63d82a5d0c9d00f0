#include "elasticity/load_basis.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "elasticity/dense_product.h"

namespace clevis::elasticity {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Left singular vectors of `rest` whose singular values are above kClear of
/// the largest: what the Gram matrix, which squares the condition, resolves.
MatrixXd clear_directions(const MatrixXd& rest, double tolerance) {
  constexpr double kClear = 1e-4;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(
      transposed_product(rest, rest));
  const VectorXd& lambda = eigen.eigenvalues();  // ascending
  const Index count = lambda.size();
  Index dropped = 0;
  double sum = 0.0;
  while (dropped < count - 1) {
    sum += std::max(0.0, lambda[dropped]);
    const bool unclear = lambda[dropped] < kClear * kClear * lambda[count - 1];
    if (!unclear && sum > tolerance * tolerance) break;
    ++dropped;
  }
  MatrixXd directions = eigen.eigenvectors().rightCols(count - dropped);
  for (Index k = 0; k < directions.cols(); ++k) {
    directions.col(k) /= std::sqrt(lambda[dropped + k]);
  }
  return product(rest, directions);
}

void append_columns(MatrixXd& columns, const MatrixXd& more) {
  columns.conservativeResize(more.rows(), columns.cols() + more.cols());
  columns.rightCols(more.cols()) = more;
}

}  // namespace

LoadBasis compress(const MatrixXd& history, double tolerance) {
  constexpr int kPasses = 4;  // each resolves four more orders of magnitude
  LoadBasis basis;
  basis.columns.resize(history.rows(), 0);
  const double scale = history.colwise().norm().maxCoeff();
  if (!(scale > 0.0)) {
    basis.coefficients.resize(0, history.cols());
    return basis;
  }
  MatrixXd rest = history / scale;
  for (int pass = 0; pass < kPasses; ++pass) {
    if (rest.colwise().norm().maxCoeff() <= tolerance) break;
    append_columns(basis.columns, clear_directions(rest, tolerance));
    rest -= product(basis.columns, transposed_product(basis.columns, rest));
  }
  const MatrixXd gram = transposed_product(basis.columns, basis.columns);
  basis.coefficients =
      gram.ldlt().solve(transposed_product(basis.columns, history));
  basis.compression_error =
      (history - product(basis.columns, basis.coefficients))
          .colwise()
          .norm()
          .maxCoeff() /
      scale;
  return basis;
}

}  // namespace clevis::elasticity
