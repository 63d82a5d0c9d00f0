#include "elasticity/assembly/initial_stress.h"

#include <array>
#include <utility>
#include <vector>

#include "elasticity/algebra/dense_product.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Components xx, yy, zz, xy, yz, xz.
constexpr std::array<std::pair<int, int>, 6> kComponents = {
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}}};

}  // namespace

InitialStress::InitialStress(const Discretization<3>& discretization,
                             const part::Material& material, MatrixXd columns)
    : discretization_(discretization),
      lame_(lame_constants<3>(material)),
      columns_(std::move(columns)),
      rule_(stiffness_quadrature(discretization)),
      places_(displacement_places<3>(discretization.shape,
                                     discretization.displacement_degree())),
      displacement_(discretization.shape, discretization.displacement_degree(),
                    rule_.points),
      geometry_(discretization.shape, discretization.mapping_degree(),
                rule_.points),
      functions_(tabulate_displacement<3>(discretization.shape,
                                          discretization.displacement_degree(),
                                          rule_.points)) {}

InitialStress::Cell InitialStress::cell(std::size_t c) const {
  auto at = cell_geometry<3>(discretization_.cell_points[c], geometry_);
  VectorXd weights = rule_.weights.cwiseProduct(at.determinant);
  return {std::move(at), std::move(weights)};
}

/// Row block d holds ∂u/∂x_d at the points, column block a component a.
MatrixXd InitialStress::slopes(const Cell& cell, std::size_t c,
                               const MatrixXd& columns) const {
  const auto& nodes = discretization_.cell_nodes[c];
  const Index rank = columns.cols();
  MatrixXd nodal(static_cast<Index>(nodes.size()), 3 * rank);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (int a = 0; a < 3; ++a) {
      nodal.row(places_[i]).segment(a * rank, rank) =
          columns.row(3 * nodes[i] + a);
    }
  }
  return physical_slopes<3>(cell.geometry, displacement_.gradients(nodal));
}

/// Row block k holds component k at the points.
MatrixXd InitialStress::stress(const Cell& cell, std::size_t c,
                               const MatrixXd& columns) const {
  const MatrixXd all = slopes(cell, c, columns);
  const Index n = cell.weights.size();
  const Index rank = columns.cols();
  const auto slope = [&](int a, int d) {
    return all.block(d * n, a * rank, n, rank);
  };
  const MatrixXd trace = slope(0, 0) + slope(1, 1) + slope(2, 2);
  MatrixXd result(6 * n, rank);
  for (std::size_t k = 0; k < kComponents.size(); ++k) {
    const auto [i, j] = kComponents[k];
    auto rows = result.middleRows(static_cast<Index>(k) * n, n);
    rows = lame_.mu * (slope(i, j) + slope(j, i));
    if (i == j) rows += lame_.lambda * trace;
  }
  return result;
}

MassMatrix InitialStress::stiffness(const NodePairs& pattern,
                                    const VectorXd& coefficients) const {
  MassMatrix matrix{pattern.row_start, pattern.column,
                    std::vector<double>(pattern.column.size(), 0.0)};
  const MatrixXd displacement = product(columns_, coefficients);
  for (std::size_t c = 0; c < discretization_.cell_nodes.size(); ++c) {
    const Cell here = cell(c);
    const VectorXd sigma = stress(here, c, displacement);
    const Index n = here.weights.size();
    const auto gradients = physical_gradients<3>(here.geometry, functions_);
    MatrixXd element = MatrixXd::Zero(gradients[0].cols(), gradients[0].cols());
    for (std::size_t i = 0; i < 3; ++i) {
      // Σ_j σ_ij ∂N/∂x_j, weighted.
      MatrixXd flux = MatrixXd::Zero(n, element.cols());
      for (std::size_t k = 0; k < kComponents.size(); ++k) {
        const auto [a, b] = kComponents[k];
        const auto row = static_cast<int>(i);
        if (a != row && b != row) continue;
        const auto j = static_cast<std::size_t>(a == row ? b : a);
        flux += sigma.segment(static_cast<Index>(k) * n, n)
                    .cwiseProduct(here.weights)
                    .asDiagonal() *
                gradients[j];
      }
      element += transposed_product(gradients[i], flux);
    }
    add_element(discretization_.cell_nodes[c], element, matrix);
  }
  return matrix;
}

MassMatrix InitialStress::unit_stiffness(const NodePairs& pattern) const {
  MassMatrix matrix{pattern.row_start, pattern.column,
                    std::vector<double>(pattern.column.size(), 0.0)};
  for (std::size_t c = 0; c < discretization_.cell_nodes.size(); ++c) {
    const Cell here = cell(c);
    const auto gradients = physical_gradients<3>(here.geometry, functions_);
    MatrixXd element = MatrixXd::Zero(gradients[0].cols(), gradients[0].cols());
    for (const MatrixXd& gradient : gradients) {
      element +=
          transposed_product(gradient, here.weights.asDiagonal() * gradient);
    }
    add_element(discretization_.cell_nodes[c], element, matrix);
  }
  return matrix;
}

MassMatrix InitialStress::mass(const NodePairs& pattern, double density) const {
  MassMatrix matrix{pattern.row_start, pattern.column,
                    std::vector<double>(pattern.column.size(), 0.0)};
  for (std::size_t c = 0; c < discretization_.cell_nodes.size(); ++c) {
    const MatrixXd element = transposed_product(
        functions_.values,
        density * (cell(c).weights.asDiagonal() * functions_.values));
    add_element(discretization_.cell_nodes[c], element, matrix);
  }
  return matrix;
}

MatrixXd InitialStress::forms(const NodePairs& pattern, const MatrixXd& vectors,
                              Index first) const {
  const Index m = vectors.cols();
  const Index pairs_before = first * (first + 1) / 2;
  MatrixXd result =
      MatrixXd::Zero(m * (m + 1) / 2 - pairs_before, columns_.cols());
  // The matrix of a stress costs less than pairs of slopes where cells have few
  // nodes.
  if (columns_.cols() == 1 &&
      discretization_.shape == mesh::CellShape::kSimplex) {
    const MassMatrix matrix = stiffness(pattern, VectorXd::Ones(1));
    const MatrixXd all = transposed_product(
        vectors, multiply(matrix, vectors.rightCols(m - first)));
    Index pair = 0;
    for (Index q = first; q < m; ++q) {
      for (Index p = 0; p <= q; ++p) result(pair++, 0) = all(p, q - first);
    }
    return result;
  }
  for (std::size_t c = 0; c < discretization_.cell_nodes.size(); ++c) {
    const Cell here = cell(c);
    const Index n = here.weights.size();
    const MatrixXd all = slopes(here, c, vectors);
    const auto slope = [&](Index vector, Index a, Index d) {
      return all.col(a * m + vector).segment(d * n, n).array();
    };
    MatrixXd pairs(6 * n, result.rows());
    Index pair = 0;
    for (Index q = first; q < m; ++q) {
      for (Index p = 0; p <= q; ++p, ++pair) {
        for (std::size_t k = 0; k < kComponents.size(); ++k) {
          const auto [i, j] = kComponents[k];
          auto rows =
              pairs.col(pair).segment(static_cast<Index>(k) * n, n).array();
          rows.setZero();
          for (Index a = 0; a < 3; ++a) {
            rows += slope(p, a, i) * slope(q, a, j);
            if (i != j) rows += slope(p, a, j) * slope(q, a, i);
          }
          rows *= here.weights.array();
        }
      }
    }
    result += transposed_product(pairs, stress(here, c, columns_));
  }
  return result;
}

MatrixXd multiply(const MassMatrix& matrix, const MatrixXd& displacements) {
  const auto nodes = static_cast<Index>(matrix.row_start.size()) - 1;
  const Index m = displacements.cols();
  // All components of all columns of a node side by side.
  MatrixXd from(3 * m, nodes);
  for (Index column = 0; column < m; ++column) {
    from.middleRows(3 * column, 3) =
        Eigen::Map<const MatrixXd>(displacements.col(column).data(), 3, nodes);
  }
  MatrixXd to = MatrixXd::Zero(3 * m, nodes);
  for (Index i = 0; i < nodes; ++i) {
    const auto row = static_cast<std::size_t>(i);
    for (int k = matrix.row_start[row]; k < matrix.row_start[row + 1]; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const int j = matrix.column[at];
      to.col(i) += matrix.value[at] * from.col(j);
      if (j != i) to.col(j) += matrix.value[at] * from.col(i);
    }
  }
  MatrixXd result(displacements.rows(), m);
  for (Index column = 0; column < m; ++column) {
    Eigen::Map<MatrixXd>(result.col(column).data(), 3, nodes) =
        to.middleRows(3 * column, 3);
  }
  return result;
}

}  // namespace clevis::elasticity
