#include "mesh/quality/simplex_quality.h"

#include <algorithm>

#include <Eigen/LU>

namespace clevis::mesh {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// How often a tetrahedron is split before it is given up as folded.
constexpr int kSplits = 4;

}  // namespace

SimplexQuality::SimplexQuality(int degree)
    : degree_(degree), nodes_(simplex_nodes<3>(degree)) {
  const int order = 3 * (degree - 1);
  const auto nodes = simplex_nodes<3>(order);
  at_nodes_ = simplex_lagrange<3>(degree, nodes);
  to_bernstein_ = bernstein<3>(order, nodes).value.inverse();
  if (degree == 1) return;
  const auto corners = simplex_nodes<3>(2);  // and middles of the edges
  for (const auto& part : simplex_parts<3>(2)) {
    SimplexPoints<3> inside = corners.col(part[0]).replicate(1, nodes.cols());
    for (int d = 0; d < 3; ++d) {
      inside += (corners.col(part[std::size_t(d) + 1]) - corners.col(part[0])) *
                nodes.row(d);
    }
    split_.emplace_back(to_bernstein_ * bernstein<3>(order, inside).value);
  }
}

double SimplexQuality::lower_bound(const Eigen::VectorXd& coefficients,
                                   int splits) const {
  const double bound = coefficients.minCoeff();
  if (bound > 0.0 || splits == 0) return bound;
  double lowest = coefficients.maxCoeff();
  for (const MatrixXd& part : split_) {
    lowest = std::min(lowest, lower_bound(part * coefficients, splits - 1));
    if (!(lowest > 0.0)) break;
  }
  return lowest;
}

CellQuality SimplexQuality::of(const Eigen::Matrix3Xd& cell_points) const {
  if (const auto edges = affine_edges<3>(cell_points, nodes_)) {
    const double lengths = edges->colwise().norm().prod();
    const double det = edges->determinant();
    return {det, det, lengths > 0.0 ? det / lengths : 0.0};
  }
  const auto grid = map_simplex<3>(cell_points, at_nodes_);
  Eigen::VectorXd determinant(grid.points.cols());
  double scaled = 1.0, volume_scale = 0.0;
  for (Index q = 0; q < grid.points.cols(); ++q) {
    const Eigen::Matrix3d J = grid.jacobian(q);
    const double lengths = J.colwise().norm().prod();
    determinant[q] = J.determinant();
    volume_scale = std::max(volume_scale, lengths);
    scaled = std::min(scaled, lengths > 0.0 ? determinant[q] / lengths : 0.0);
  }
  CellQuality quality{determinant.minCoeff(), determinant.maxCoeff(), scaled};
  if (degree_ == 1 || !(scaled > 0.0)) return quality;
  quality.min_jacobian = lower_bound(to_bernstein_ * determinant, kSplits);
  if (!(quality.min_jacobian > 0.0)) {
    quality.scaled_jacobian = quality.min_jacobian / volume_scale;
  }
  return quality;
}

}  // namespace clevis::mesh
