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

LoadBasis compress(const MatrixXd& history, double tolerance) {
  LoadBasis basis;
  const double scale = history.colwise().norm().maxCoeff();
  if (!(scale > 0.0)) {
    basis.columns.resize(history.rows(), 0);
    basis.coefficients.resize(0, history.cols());
    return basis;
  }
  const MatrixXd scaled = history / scale;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(
      transposed_product(scaled, scaled));
  // Eigenvalues ascend. An instant's error is at most the root of the sum of
  // all that is dropped.
  const VectorXd& lambda = eigen.eigenvalues();
  const Index count = lambda.size();
  Index dropped = 0;
  double sum = 0.0;
  while (dropped < count - 1) {
    sum += std::max(0.0, lambda[dropped]);
    if (sum > tolerance * tolerance) break;
    ++dropped;
  }
  const Index rank = count - dropped;
  MatrixXd directions = eigen.eigenvectors().rightCols(rank);
  for (Index k = 0; k < rank; ++k) {
    directions.col(k) /= std::sqrt(lambda[dropped + k]);
  }
  basis.columns = product(scaled, directions);
  // Small singular values leave Q not quite orthonormal, hence its own Gram
  // matrix in the least-squares coefficients.
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
