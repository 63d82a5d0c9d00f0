#include "elasticity/algebra/principal_columns.h"

#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

#include "elasticity/algebra/dense_product.h"

namespace clevis::elasticity {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

PrincipalColumns principal_columns(const MatrixXd& gram,
                                   const MatrixXd& coefficients,
                                   double admitted, Index most) {
  constexpr double kRoundOff = 1e-12;  // of the largest eigenvalue
  // Columns of one length: their units may differ by orders.
  const VectorXd length =
      gram.diagonal().cwiseMax(std::numeric_limits<double>::min()).cwiseSqrt();
  const VectorXd unit = length.cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> metric(
      unit.asDiagonal() * gram * unit.asDiagonal());
  const double floor = kRoundOff * metric.eigenvalues().maxCoeff();
  const VectorXd root = metric.eigenvalues().cwiseMax(floor).cwiseSqrt();
  const MatrixXd in_norm =
      root.asDiagonal() *
      transposed_product(metric.eigenvectors(),
                         length.asDiagonal() * coefficients);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> principal(
      product(in_norm, in_norm.transpose()));
  const MatrixXd parts = transposed_product(principal.eigenvectors(), in_norm);
  VectorXd missing = in_norm.colwise().squaredNorm();
  const double wanted = admitted * admitted * missing.maxCoeff();
  Index kept = 0;
  while (kept < gram.rows() && kept < most &&
         (kept == 0 || missing.maxCoeff() > wanted)) {
    ++kept;
    missing -= parts.row(gram.rows() - kept).cwiseAbs2().transpose();
  }
  return {unit.asDiagonal() * metric.eigenvectors() *
              root.cwiseInverse().asDiagonal() *
              principal.eigenvectors().rightCols(kept),
          parts.bottomRows(kept)};
}

MatrixXd orthonormal_combinations(const MatrixXd& gram, double dependent) {
  const VectorXd unit = gram.diagonal().unaryExpr([](double square) {
    return square > 0.0 ? 1.0 / std::sqrt(square) : 0.0;
  });
  const Eigen::SelfAdjointEigenSolver<MatrixXd> metric(
      unit.asDiagonal() * gram * unit.asDiagonal());
  const VectorXd& values = metric.eigenvalues();
  const Index kept = (values.array() > dependent * values.maxCoeff()).count();
  return unit.asDiagonal() * metric.eigenvectors().rightCols(kept) *
         values.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
}

}  // namespace clevis::elasticity
