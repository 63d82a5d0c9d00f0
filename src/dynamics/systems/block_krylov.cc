#include "dynamics/systems/block_krylov.h"

#include <cmath>
#include <random>
#include <utility>

#include <Eigen/Eigenvalues>

namespace clevis::dynamics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Part of a column below which its rest is round-off.
constexpr double kNothing = 1e-11;

MatrixXd beside(const MatrixXd& left, const MatrixXd& right) {
  MatrixXd result(right.rows(), left.cols() + right.cols());
  result << left, right;
  return result;
}

}  // namespace

MatrixXd random_block(Index rows, Index columns) {
  std::mt19937 random(1);
  MatrixXd block(rows, columns);
  for (Index j = 0; j < columns; ++j) {
    for (Index i = 0; i < rows; ++i) {
      block(i, j) = static_cast<double>(random()) / 4294967296.0 - 0.5;
    }
  }
  return block;
}

BlockKrylov::BlockKrylov(const LinearSystem& system, BlockOperator solve,
                         const MatrixXd& start, MatrixXd deflated)
    : BlockKrylov(SelfAdjoint{system.size, system.mass,
                              [solve = std::move(solve)](
                                  const MatrixXd&, const MatrixXd& weighted) {
                                return solve(weighted);
                              },
                              system.admitted},
                  start, std::move(deflated)) {}

BlockKrylov::BlockKrylov(SelfAdjoint system, const MatrixXd& start,
                         MatrixXd deflated)
    : system_(std::move(system)),
      deflated_(std::move(deflated)),
      basis_(system_.size, 0),
      projection_(0, 0) {
  MatrixXd block = start;
  double scale = 0.0;
  orthogonalise(block, scale);
  append(block, scale);
}

MatrixXd BlockKrylov::take_out(MatrixXd& block,
                               const MatrixXd& weighted) const {
  if (deflated_.cols() > 0) {
    block -= deflated_ * (deflated_.transpose() * weighted);
  }
  const auto space = basis_.leftCols(columns_);
  MatrixXd inside = space.transpose() * weighted;
  if (columns_ > 0) block -= space * inside;
  return inside;
}

MatrixXd BlockKrylov::orthogonalise(MatrixXd& block, double& scale) const {
  MatrixXd weighted = system_.product(block);
  scale = block.cwiseProduct(weighted).colwise().sum().maxCoeff();
  MatrixXd components = take_out(block, weighted);
  weighted = system_.product(block);
  components += take_out(block, weighted);
  return components;
}

/// Once more against the space and the columns before: what is small carries
/// the round-off of what was large. Again where little is left of it.
/// @param image  M column, made anew.
/// @return whether anything is left but round-off.
bool BlockKrylov::settle(const MatrixXd& columns, MatrixXd& column,
                         MatrixXd& image) const {
  constexpr int kMost = 4;
  constexpr double kMuch = 0.5;
  if (columns.cols() == 0 && !system_.admitted) return true;
  for (int pass = 0; pass < kMost; ++pass) {
    if (system_.admitted) column = system_.admitted(column);
    take_out(column, system_.product(column));
    if (columns.cols() > 0)
      column -= columns * (weighted_.transpose() * column);
    image = system_.product(column);
    const double norm = std::sqrt(column.cwiseProduct(image).sum());
    if (!(norm > 0.0)) return false;
    column /= norm;
    image /= norm;
    if (norm > kMuch) return true;
  }
  return false;
}

MatrixXd BlockKrylov::append(const MatrixXd& block, double scale) {
  // Gram-Schmidt with pivots: the largest rest is next.
  MatrixXd rest = block;
  MatrixXd weighted_rest = system_.product(rest);
  MatrixXd columns(block.rows(), 0);
  MatrixXd triangle = MatrixXd::Zero(0, block.cols());
  weighted_.resize(block.rows(), 0);
  for (Index k = 0; k < block.cols(); ++k) {
    Index at = 0;
    const double square =
        rest.cwiseProduct(weighted_rest).colwise().sum().maxCoeff(&at);
    if (!(square > kNothing * kNothing * scale)) break;
    MatrixXd column = rest.col(at) / std::sqrt(square);
    MatrixXd image = weighted_rest.col(at) / std::sqrt(square);
    if (!settle(columns, column, image)) break;
    triangle.conservativeResize(k + 1, Eigen::NoChange);
    triangle.row(k) = image.transpose() * rest;
    rest -= column * triangle.row(k);
    weighted_rest -= image * triangle.row(k);
    columns = beside(columns, column);
    weighted_ = beside(weighted_, image);
  }
  if (columns_ + columns.cols() > basis_.cols()) {
    basis_.conservativeResize(Eigen::NoChange, 2 * (columns_ + columns.cols()));
  }
  basis_.middleCols(columns_, columns.cols()) = columns;
  columns_ += columns.cols();
  return triangle;
}

void BlockKrylov::extend() {
  if (is_closed()) return;
  const Index before = done_;
  const Index width = columns_ - done_;
  MatrixXd image = system_.apply(basis_.middleCols(before, width), weighted_);
  double scale = 0.0;
  const MatrixXd components = orthogonalise(image, scale);  // all of the space
  done_ = columns_;
  if (done_ > projection_.cols()) {
    projection_.conservativeResize(2 * done_, 2 * done_);
  }
  projection_.block(0, before, done_, width) = components;
  projection_.block(before, 0, width, before) =
      components.topRows(before).transpose();
  const MatrixXd triangle = append(image, scale);
  overhang_ = MatrixXd::Zero(triangle.rows(), done_);
  overhang_.rightCols(width) = triangle;
}

BlockKrylov::RitzValues BlockKrylov::ritz_values() const {
  const MatrixXd projection = projection_.topLeftCorner(done_, done_);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(
      0.5 * (projection + projection.transpose()));
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
