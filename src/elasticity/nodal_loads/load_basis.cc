#include "elasticity/nodal_loads/load_basis.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "base/algebra/append_columns.h"
#include "elasticity/algebra/dense_product.h"

namespace clevis::elasticity {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// How many of the eigenvalues of a Gram matrix, which ascend, to leave out:
/// those of singular values below kClear of the largest, which the Gram matrix,
/// squaring the condition, does not resolve, and those within the tolerance.
Index count_of_unclear(const VectorXd& lambda, double tolerance) {
  constexpr double kClear = 1e-4;
  const Index count = lambda.size();
  Index dropped = 0;
  double sum = 0.0;
  while (dropped < count - 1) {
    sum += std::max(0.0, lambda[dropped]);
    const bool unclear = lambda[dropped] < kClear * kClear * lambda[count - 1];
    if (!unclear && sum > tolerance * tolerance) break;
    ++dropped;
  }
  return dropped;
}

/// Combinations of the columns of `rest` that are its clear left singular
/// vectors.
MatrixXd clear_combinations(const MatrixXd& rest, double tolerance) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(
      transposed_product(rest, rest));
  const VectorXd& lambda = eigen.eigenvalues();
  const Index dropped = count_of_unclear(lambda, tolerance);
  MatrixXd directions = eigen.eigenvectors().rightCols(lambda.size() - dropped);
  for (Index k = 0; k < directions.cols(); ++k) {
    directions.col(k) /= std::sqrt(lambda[dropped + k]);
  }
  return directions;
}

MatrixXd clear_directions(const MatrixXd& rest, double tolerance) {
  if (rest.rows() < rest.cols()) {  // the smaller Gram matrix has them itself
    const MatrixXd turned = rest.transpose();
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(
        transposed_product(turned, turned));
    const VectorXd& lambda = eigen.eigenvalues();
    return eigen.eigenvectors().rightCols(lambda.size() -
                                          count_of_unclear(lambda, tolerance));
  }
  return product(rest, clear_combinations(rest, tolerance));
}

/// Basis of the history relative to a scale.
/// @param weights  of the instants' errors.
LoadBasis compress_over(const MatrixXd& history, double tolerance, double scale,
                        const VectorXd& weights) {
  constexpr int kPasses = 4;  // each resolves four more orders of magnitude
  LoadBasis basis;
  basis.columns.resize(history.rows(), 0);
  basis.coefficients.resize(0, history.cols());
  if (!(scale > 0.0)) return basis;
  MatrixXd rest = history * (weights / scale).asDiagonal();
  for (int pass = 0; pass < kPasses; ++pass) {
    if (rest.colwise().norm().maxCoeff() <= tolerance) break;
    append_columns(clear_directions(rest, tolerance), basis.columns);
    rest -= product(basis.columns, transposed_product(basis.columns, rest));
  }
  const MatrixXd gram = transposed_product(basis.columns, basis.columns);
  basis.coefficients =
      gram.ldlt().solve(transposed_product(basis.columns, history));
  basis.compression_error =
      (history - product(basis.columns, basis.coefficients))
          .colwise()
          .norm()
          .cwiseProduct(weights.transpose())
          .maxCoeff() /
      scale;
  return basis;
}

/// An orthonormal basis of columns of like size, as combinations of them:
/// `combine` holds their coefficients, `coordinates` the columns in the basis.
struct Orthonormal {
  MatrixXd combine, coordinates;
};

/// Part of a column that counts.
constexpr double kCounts = 1e-10;

/// By passes as in compress_over, every direction that counts.
Orthonormal orthonormalise_by_passes(const MatrixXd& columns) {
  // Every direction is a combination of what is left of the columns, which is
  // one of the columns themselves.
  const Index count = columns.cols();
  Orthonormal result{MatrixXd(count, 0), {}};
  MatrixXd basis(columns.rows(), 0);
  MatrixXd rest = columns;
  MatrixXd rest_of_columns = MatrixXd::Identity(count, count);
  for (int pass = 0; pass < 4; ++pass) {
    if (rest.colwise().norm().maxCoeff() <= kCounts) break;
    const MatrixXd directions = clear_combinations(rest, kCounts);
    append_columns(product(rest, directions), basis);
    append_columns(product(rest_of_columns, directions), result.combine);
    const MatrixXd along = transposed_product(basis, rest);
    rest -= product(basis, along);
    rest_of_columns -= product(result.combine, along);
  }
  result.coordinates = transposed_product(basis, columns);
  return result;
}

/// By the Gram matrix where the columns are clearly independent, or some are
/// combinations of the others but for what does not count; else by passes.
/// @param choose  combinations of `columns` that these are.
Orthonormal orthonormalise(const SplitColumns& columns, const MatrixXd& choose,
                           const MatrixXd& gram) {
  constexpr double kIndependent = 1e-3;
  const Index count = gram.cols();
  const Eigen::LLT<MatrixXd> llt(gram);
  if (llt.info() == Eigen::Success &&
      llt.matrixLLT().diagonal().minCoeff() > kIndependent) {
    const MatrixXd upper = llt.matrixU();
    return {llt.matrixU().solve(MatrixXd::Identity(count, count)), upper};
  }
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(gram);
  const auto& lambda = eigen.eigenvalues();
  const Index kept = (lambda.array() > kIndependent * kIndependent).count();
  const MatrixXd dropped = eigen.eigenvectors().leftCols(count - kept);
  for (Index k = 0; k < dropped.cols(); ++k) {
    if (!(columns.times(choose * dropped.col(k)).norm() <= kCounts)) {
      return orthonormalise_by_passes(columns.times(choose));
    }
  }
  const MatrixXd directions = eigen.eigenvectors().rightCols(kept);
  const VectorXd size = lambda.tail(kept).cwiseSqrt();
  return {directions * size.cwiseInverse().asDiagonal(),
          size.asDiagonal() * directions.transpose()};
}

/// Norm of the largest instant, of the columns' Gram matrix: f_i = A c_i is
/// not formed.
double largest_instant(const MatrixXd& gram, const MatrixXd& c) {
  const double squared =
      c.cwiseProduct(product(gram, c)).colwise().sum().maxCoeff();
  return std::sqrt(std::max(0.0, squared));
}

}  // namespace

LoadBasis compress(const MatrixXd& history, double tolerance) {
  return compress_over(history, tolerance, history.colwise().norm().maxCoeff(),
                       VectorXd::Ones(history.cols()));
}

SplitLoads split(LoadBasis loads) {
  constexpr Index kSmallShare = 4;  // of the rows, for it to be worth while
  const MatrixXd& columns = loads.columns;
  std::vector<Index> few, wide;
  std::vector<bool> occurs(static_cast<std::size_t>(columns.rows()), false);
  for (Index k = 0; k < columns.cols(); ++k) {
    const auto column = columns.col(k).array();
    if (kSmallShare * (column != 0.0).count() > columns.rows()) {
      wide.push_back(k);
      continue;
    }
    few.push_back(k);
    for (Index row = 0; row < columns.rows(); ++row) {
      if (column[row] != 0.0) occurs[static_cast<std::size_t>(row)] = true;
    }
  }
  std::vector<Index> rows;
  for (Index row = 0; row < columns.rows(); ++row) {
    if (occurs[static_cast<std::size_t>(row)]) rows.push_back(row);
  }
  if (few.empty() || kSmallShare * std::ssize(rows) > columns.rows()) {
    return {{{}, MatrixXd(0, 0), std::move(loads.columns)},
            std::move(loads.coefficients)};
  }
  MatrixXd coefficients(loads.coefficients.rows(), loads.coefficients.cols());
  coefficients << loads.coefficients(few, Eigen::all),
      loads.coefficients(wide, Eigen::all);
  return {{rows, columns(rows, few), columns(Eigen::all, wide)},
          std::move(coefficients)};
}

double largest_instant(const SplitLoads& loads) {
  if (loads.coefficients.rows() == 0) return 0.0;
  return largest_instant(loads.columns.gram(), loads.coefficients);
}

double largest_instant(const LoadBasis& loads) {
  if (loads.coefficients.rows() == 0) return 0.0;
  return largest_instant(transposed_product(loads.columns, loads.columns),
                         loads.coefficients);
}

LoadBasis compress(const SplitLoads& loads, double tolerance, double scale,
                   const VectorXd& admitted) {
  const Index count = loads.columns.cols();
  LoadBasis none{MatrixXd(loads.columns.rows(), 0),
                 MatrixXd(0, loads.coefficients.cols())};
  if (count == 0) return none;
  const MatrixXd gram = loads.columns.gram();
  if (scale == 0.0) scale = largest_instant(gram, loads.coefficients);
  const VectorXd size = gram.diagonal().cwiseSqrt();
  // The part that counts, to unit length: X chooses it of the columns.
  MatrixXd choose = MatrixXd::Zero(count, count);
  MatrixXd coefficients(count, loads.coefficients.cols());
  Index kept = 0;
  for (Index k = 0; k < count; ++k) {
    const double counts =
        size[k] * loads.coefficients.row(k).cwiseAbs().maxCoeff();
    if (counts <= 1e-4 * tolerance * scale) continue;
    choose(k, kept) = 1.0 / size[k];
    coefficients.row(kept++) = loads.coefficients.row(k) * size[k];
  }
  if (kept == 0) return none;
  choose.conservativeResize(Eigen::NoChange, kept);
  coefficients.conservativeResize(kept, Eigen::NoChange);
  const Orthonormal orthonormal =
      orthonormalise(loads.columns, choose, choose.transpose() * gram * choose);
  const VectorXd weights =
      admitted.size() == 0
          ? VectorXd(VectorXd::Ones(coefficients.cols()))
          : VectorXd(tolerance * admitted.cwiseMax(tolerance).cwiseInverse());
  LoadBasis basis =
      compress_over(product(orthonormal.coordinates, coefficients), tolerance,
                    scale, weights);
  basis.columns = loads.columns.times(
      product(choose, product(orthonormal.combine, basis.columns)));
  return basis;
}

}  // namespace clevis::elasticity
