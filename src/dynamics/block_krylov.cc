#include "dynamics/block_krylov.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>

namespace clevis::dynamics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// What is left of a column beside what it was, for it to be round-off.
constexpr double kNothing = 1e-11;

MatrixXd beside(const MatrixXd& left, const MatrixXd& right) {
  MatrixXd result(right.rows(), left.cols() + right.cols());
  result << left, right;
  return result;
}

}  // namespace

BlockKrylov::BlockKrylov(const LinearSystem& system, BlockOperator solve,
                         const MatrixXd& start, MatrixXd deflated)
    : system_(system),
      solve_(std::move(solve)),
      deflated_(std::move(deflated)),
      basis_(system.size, 0),
      projection_(0, 0) {
  MatrixXd block = start;
  orthogonalise(block);
  MatrixXd triangle;
  next_ = split(block, triangle);
  basis_ = next_;
}

MatrixXd BlockKrylov::orthogonalise(MatrixXd& block) const {
  MatrixXd components = MatrixXd::Zero(basis_.cols(), block.cols());
  for (int pass = 0; pass < 2; ++pass) {
    const MatrixXd weighted = system_.mass(block);
    if (deflated_.cols() > 0) {
      block -= deflated_ * (deflated_.transpose() * weighted);
    }
    if (basis_.cols() == 0) continue;
    const MatrixXd inside = basis_.transpose() * weighted;
    block -= basis_ * inside;
    components += inside;
  }
  return components;
}

MatrixXd BlockKrylov::split(const MatrixXd& block, MatrixXd& triangle) const {
  // Gram-Schmidt with pivots: the largest rest is next.
  MatrixXd rest = block;
  MatrixXd weighted_rest = system_.mass(rest);
  MatrixXd columns(block.rows(), 0);
  MatrixXd weighted(block.rows(), 0);
  triangle = MatrixXd::Zero(0, block.cols());
  double largest = 0.0;
  for (Index k = 0; k < block.cols(); ++k) {
    Index at = 0;
    const double square =
        rest.cwiseProduct(weighted_rest).colwise().sum().maxCoeff(&at);
    largest = std::max(largest, square);
    if (!(square > kNothing * kNothing * largest)) break;
    MatrixXd column = rest.col(at) / std::sqrt(square);
    // Once more against the space and the columns before: what is small
    // carries the round-off of what was large.
    orthogonalise(column);
    column -= columns * (weighted.transpose() * column);
    MatrixXd image = system_.mass(column);
    const double norm = std::sqrt(column.cwiseProduct(image).sum());
    column /= norm;
    image /= norm;
    triangle.conservativeResize(k + 1, Eigen::NoChange);
    triangle.row(k) = image.transpose() * rest;
    rest -= column * triangle.row(k);
    weighted_rest -= image * triangle.row(k);
    columns = beside(columns, column);
    weighted = beside(weighted, image);
  }
  return columns;
}

void BlockKrylov::extend() {
  if (is_closed()) return;
  const Index before = projection_.cols();
  const Index width = next_.cols();
  MatrixXd image = solve_(system_.mass(next_));
  const MatrixXd components = orthogonalise(image);  // all of basis_
  MatrixXd grown = MatrixXd::Zero(before + width, before + width);
  grown.topLeftCorner(before, before) = projection_;
  grown.rightCols(width) = components;
  grown.bottomLeftCorner(width, before) =
      components.topRows(before).transpose();
  projection_ = 0.5 * (grown + grown.transpose());
  MatrixXd triangle;
  next_ = split(image, triangle);
  overhang_ = MatrixXd::Zero(triangle.rows(), before + width);
  overhang_.rightCols(width) = triangle;
  basis_ = beside(basis_, next_);
}

BlockKrylov::RitzValues BlockKrylov::ritz_values() const {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(projection_);
  RitzValues result;
  result.theta = solver.eigenvalues().reverse();
  result.vectors = solver.eigenvectors().rowwise().reverse();
  result.residual =
      overhang_.rows() == 0
          ? VectorXd(VectorXd::Zero(size()))
          : VectorXd((overhang_ * result.vectors).colwise().norm().transpose());
  return result;
}

MatrixXd mass_orthonormal(const LinearSystem& system, const MatrixXd& columns) {
  if (columns.cols() == 0) return columns;
  MatrixXd result = columns;
  for (int pass = 0; pass < 2; ++pass) {
    const MatrixXd gram = result.transpose() * system.mass(result);
    const VectorXd scale = gram.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(
        scale.asDiagonal() * gram * scale.asDiagonal());
    result = result * scale.asDiagonal() * solver.eigenvectors() *
             solver.eigenvalues().cwiseSqrt().cwiseInverse().asDiagonal();
  }
  return result;
}

}  // namespace clevis::dynamics
