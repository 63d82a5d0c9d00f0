#include "elasticity/revolution/meridian_stiffness.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "elasticity/algebra/dense_product.h"
#include "elasticity/assembly/node_pairs.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/fe_space/tabulation.h"
#include "elasticity/revolution/harmonic.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;

/// Integrals over a cell of the meridian, functions × functions, that an
/// element matrix of any order is made of.
struct CellIntegrals {
  MatrixXd xx, xr, rr;  ///< ∫ ∂N_i ∂N_j r dA
  MatrixXd x, r;        ///< ∫ N_i ∂N_j dA
  MatrixXd over_r;      ///< ∫ N_i N_j / r dA
};

CellIntegrals integrate(const CellGeometry<2>& cell,
                        const Tabulation& displacement,
                        const Eigen::VectorXd& rule_weights) {
  const auto gradients = physical_gradients(cell, displacement);
  const Eigen::VectorXd area = rule_weights.cwiseProduct(cell.determinant);
  const Eigen::VectorXd radius = cell.points.row(1).transpose();
  const auto weight_r = area.cwiseProduct(radius).eval();
  const MatrixXd x_r = weight_r.asDiagonal() * gradients[0];
  const MatrixXd r_r = weight_r.asDiagonal() * gradients[1];
  const MatrixXd n_1 = area.asDiagonal() * displacement.values;
  const MatrixXd n_over_r =
      area.cwiseQuotient(radius).asDiagonal() * displacement.values;
  return {transposed_product(gradients[0], x_r),
          transposed_product(gradients[0], r_r),
          transposed_product(gradients[1], r_r),
          transposed_product(n_1, gradients[0]),
          transposed_product(n_1, gradients[1]),
          transposed_product(displacement.values, n_over_r)};
}

/// Blocks of A, B and C for a pair of nodes in (u_x, u_r, u_θ).
struct Blocks {
  Matrix3d constant = Matrix3d::Zero(), linear = Matrix3d::Zero(),
           quadratic = Matrix3d::Zero();
};

// With amplitudes a, the strains of a term are
//   ε_x = ∂_x a_x          γ_xr = ∂_r a_x + ∂_x a_r
//   ε_r = ∂_r a_r          γ_rθ = −n a_r/r + ∂_r a_θ − a_θ/r
//   ε_θ = (a_r + n a_θ)/r  γ_xθ = ∂_x a_θ − n a_x/r
// times cos nθ in the normal strains and γ_xr, sin nθ in the other two.
Blocks element_blocks(const CellIntegrals& c, const LameConstants<3>& lame,
                      Index i, Index j) {
  const double l = lame.lambda;
  const double m = lame.mu;
  const double M = c.over_r(i, j);
  Blocks k;
  k.constant(0, 0) = (l + 2.0 * m) * c.xx(i, j) + m * c.rr(i, j);
  k.constant(0, 1) = l * (c.xr(i, j) + c.x(j, i)) + m * c.xr(j, i);
  k.constant(1, 0) = l * (c.xr(j, i) + c.x(i, j)) + m * c.xr(i, j);
  k.constant(1, 1) = (l + 2.0 * m) * (c.rr(i, j) + M) +
                     l * (c.r(i, j) + c.r(j, i)) + m * c.xx(i, j);
  k.constant(2, 2) = m * (c.rr(i, j) - c.r(i, j) - c.r(j, i) + M + c.xx(i, j));
  k.linear(0, 2) = l * c.x(j, i) - m * c.x(i, j);
  k.linear(2, 0) = l * c.x(i, j) - m * c.x(j, i);
  k.linear(1, 2) = l * (c.r(j, i) + M) + m * (3.0 * M - c.r(i, j));
  k.linear(2, 1) = l * (c.r(i, j) + M) + m * (3.0 * M - c.r(j, i));
  k.quadratic(0, 0) = m * M;
  k.quadratic(1, 1) = m * M;
  k.quadratic(2, 2) = (l + 2.0 * m) * M;
  return k;
}

}  // namespace

MeridianStiffness::MeridianStiffness(const Discretization<2>& meridian,
                                     const part::Material& material,
                                     const std::string& place) {
  NodePairs pairs = node_pairs(meridian.cell_nodes, meridian.nodes);
  constant_.row_start = std::move(pairs.row_start);
  constant_.column = std::move(pairs.column);
  constant_.block.assign(constant_.column.size(), Matrix3d::Zero());
  linear_.assign(constant_.block.size(), Matrix3d::Zero());
  quadratic_ = linear_;
  const auto lame = lame_constants<3>(material);
  // One point more for r and 1/r, another for curved cells.
  const int points = meridian.degree + (meridian.geometry_degree > 1 ? 3 : 2);
  const auto rule = gauss<2>(meridian.shape, points);
  const auto displacement =
      tabulate_displacement<2>(meridian.shape, meridian.degree, rule.points);
  const CellInterpolation<2> geometry(meridian.shape, meridian.geometry_degree,
                                      rule.points);
  const Matrix3d mix = mix_components();
  for (std::size_t c = 0; c < meridian.cell_nodes.size(); ++c) {
    const auto cell = cell_geometry<2>(meridian.cell_points[c], geometry);
    if (!(cell.determinant.minCoeff() > 0.0)) {
      throw Error("M005", place,
                  fmt::format("cell {} of the meridian folds when its geometry "
                              "is interpolated with degree {}",
                              c, meridian.geometry_degree),
                  "Mesh the place finer.");
    }
    const auto integrals = integrate(cell, displacement, rule.weights);
    const auto& ids = meridian.cell_nodes[c];
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const auto row = static_cast<std::size_t>(ids[i]);
      const auto begin = constant_.column.begin() + constant_.row_start[row];
      const auto end = constant_.column.begin() + constant_.row_start[row + 1];
      for (std::size_t j = 0; j < ids.size(); ++j) {
        if (ids[j] < ids[i]) continue;
        const auto at = static_cast<std::size_t>(
            std::lower_bound(begin, end, ids[j]) - constant_.column.begin());
        const Blocks k = element_blocks(integrals, lame, static_cast<Index>(i),
                                        static_cast<Index>(j));
        constant_.block[at] += mix * k.constant * mix;
        linear_[at] += mix * k.linear * mix;
        quadratic_[at] += mix * k.quadratic * mix;
      }
    }
  }
}

StiffnessMatrix<3> MeridianStiffness::of_order(int order) const {
  StiffnessMatrix<3> matrix = constant_;
  const double norm = wave_norm({order, false});
  for (std::size_t k = 0; k < matrix.block.size(); ++k) {
    matrix.block[k] = norm * (constant_.block[k] + order * linear_[k] +
                              order * order * quadratic_[k]);
  }
  return matrix;
}

std::vector<int> axis_nodes(const Discretization<2>& meridian) {
  constexpr double kOnAxis = 1e-9;
  const auto positions = node_positions(meridian);
  const double largest = positions.row(1).maxCoeff();
  std::vector<int> nodes;
  for (int node = 0; node < meridian.nodes; ++node) {
    if (positions(1, node) <= kOnAxis * largest) nodes.push_back(node);
  }
  return nodes;
}

}  // namespace clevis::elasticity
