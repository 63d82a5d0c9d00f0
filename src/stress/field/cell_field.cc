#include "stress/field/cell_field.h"

#include <cmath>
#include <vector>

#include "elasticity/algebra/dense_product.h"

namespace clevis::stress {

using Eigen::ArrayXXd;
using Eigen::Index;
using Eigen::MatrixXd;

template <int dim>
ArrayXXd von_mises_squared(const MatrixXd& stress, Index n) {
  const auto s = [&](int k) {
    return stress.middleRows(k * n, n).array();
  };
  if constexpr (dim == 2) {
    return s(0).square() - s(0) * s(1) + s(1).square() + 3.0 * s(2).square();
  } else {
    return 0.5 * ((s(0) - s(1)).square() + (s(1) - s(2)).square() +
                  (s(2) - s(0)).square()) +
           3.0 * (s(3).square() + s(4).square() + s(5).square());
  }
}

template <int dim>
MatrixXd deviator(const MatrixXd& stress, Index n) {
  const double root = std::sqrt(3.0);
  const auto s = [&](int k) {
    return stress.middleRows(k * n, n);
  };
  MatrixXd result(kDeviatorComponents<dim> * n, stress.cols());
  const auto put = [&](int k) {
    return result.middleRows(k * n, n);
  };
  if constexpr (dim == 2) {
    put(0) = s(0) - 0.5 * s(1);
    put(1) = 0.5 * root * s(1);
    put(2) = root * s(2);
  } else {
    put(0) = s(0) - 0.5 * (s(1) + s(2));
    put(1) = 0.5 * root * (s(1) - s(2));
    for (int k = 2; k < 5; ++k) put(k) = root * s(k + 1);
  }
  return result;
}

namespace {

/// Gradients of all directions, one below the other.
MatrixXd stacked(const std::vector<MatrixXd>& gradients) {
  const Index n = gradients.front().rows();
  MatrixXd result(static_cast<Index>(gradients.size()) * n,
                  gradients.front().cols());
  for (std::size_t d = 0; d < gradients.size(); ++d) {
    result.middleRows(static_cast<Index>(d) * n, n) = gradients[d];
  }
  return result;
}

}  // namespace

template <int dim>
CellField<dim>::CellField(const elasticity::Discretization<dim>& discretization,
                          const part::Material& material,
                          const elasticity::ReferencePoints<dim>& points)
    : discretization_(discretization),
      lame_(elasticity::lame_constants<dim>(material)),
      displacement_(elasticity::tabulate_displacement<dim>(
          discretization.shape, discretization.displacement_degree(), points)),
      geometry_(elasticity::tabulate_geometry<dim>(
          discretization.shape, discretization.mapping_degree(), points)),
      slopes_(stacked(displacement_.gradients)) {
  if (!discretization.is_revolved) return;
  constexpr double kBeside = 1e-6;
  elasticity::ReferencePoints<dim> beside = points;
  beside.template topRows<2>() =
      points.template topRows<2>().cwiseMax(kBeside).cwiseMin(1.0 - kBeside);
  slopes_beside_ = stacked(
      elasticity::tabulate_displacement<dim>(
          discretization.shape, discretization.displacement_degree(), beside)
          .gradients);
  geometry_beside_ = elasticity::tabulate_geometry<dim>(
      discretization.shape, discretization.mapping_degree(), beside);
}

template <int dim>
MatrixXd CellField<dim>::stress(std::size_t cell,
                                const MatrixXd& columns) const {
  const auto n = displacement_.values.rows();
  const auto rank = columns.cols();
  const MatrixXd slopes = gradients(cell, columns);
  // slopes: row block d, column block a holds ∂u_a/∂x_d.
  const auto slope = [&](int a, int d) {
    return slopes.block(d * n, a * rank, n, rank);
  };
  MatrixXd trace = slope(0, 0);
  for (int d = 1; d < dim; ++d) trace += slope(d, d);
  MatrixXd result(kStressComponents<dim> * n, rank);
  for (int d = 0; d < dim; ++d) {
    result.middleRows(d * n, n) =
        lame_.lambda * trace + 2.0 * lame_.mu * slope(d, d);
  }
  for (int k = dim; k < kStressComponents<dim>; ++k) {
    const int a = k == 5 ? 0 : k - dim;  // xy, yz, xz
    const int b = k == 5 ? 2 : a + 1;
    result.middleRows(k * n, n) = lame_.mu * (slope(a, b) + slope(b, a));
  }
  return result;
}

template <int dim>
MatrixXd CellField<dim>::positions(std::size_t cell) const {
  return geometry_.values * discretization_.cell_points[cell].transpose();
}

template <int dim>
MatrixXd CellField<dim>::displacement(std::size_t cell,
                                      const MatrixXd& columns) const {
  return elasticity::product(displacement_.values, nodal_values(cell, columns));
}

template <int dim>
MatrixXd CellField<dim>::nodal_values(std::size_t cell,
                                      const MatrixXd& columns) const {
  const auto& nodes = discretization_.cell_nodes[cell];
  MatrixXd values(static_cast<Index>(nodes.size()), dim * columns.cols());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (int a = 0; a < dim; ++a) {
      values.row(static_cast<Index>(i))
          .segment(a * columns.cols(), columns.cols()) =
          columns.row(dim * nodes[i] + a);
    }
  }
  return values;
}

template <int dim>
MatrixXd CellField<dim>::gradients(std::size_t cell,
                                   const MatrixXd& columns) const {
  constexpr double kCollapsed = 1e-9;  // of the cell's largest determinant
  const auto& points = discretization_.cell_points[cell];
  auto at = elasticity::cell_geometry<dim>(points, geometry_);
  const bool touches_axis =
      discretization_.is_revolved &&
      at.determinant.minCoeff() <= kCollapsed * at.determinant.maxCoeff();
  if (touches_axis) {
    at = elasticity::cell_geometry<dim>(points, geometry_beside_);
  }
  const auto n = displacement_.values.rows();
  const MatrixXd reference = elasticity::product(
      touches_axis ? slopes_beside_ : slopes_, nodal_values(cell, columns));
  // ∂u/∂x_d = Σ_k ∂u/∂ξ_k ∂ξ_k/∂x_d, point by point: of the result and not of
  // the basis functions, which are many more.
  MatrixXd slopes(dim * n, reference.cols());
  for (int d = 0; d < dim; ++d) {
    Eigen::Array<double, Eigen::Dynamic, dim> factor(n, dim);
    for (Index q = 0; q < n; ++q) {
      factor.row(q) = at.inverse_jacobian[static_cast<std::size_t>(q)]
                          .col(d)
                          .transpose()
                          .array();
    }
    for (Index column = 0; column < reference.cols(); ++column) {
      auto slope = slopes.col(column).segment(d * n, n).array();
      slope = factor.col(0) * reference.col(column).head(n).array();
      for (int k = 1; k < dim; ++k) {
        slope +=
            factor.col(k) * reference.col(column).segment(k * n, n).array();
      }
    }
  }
  return slopes;
}

template ArrayXXd von_mises_squared<2>(const MatrixXd&, Index);
template ArrayXXd von_mises_squared<3>(const MatrixXd&, Index);
template MatrixXd deviator<2>(const MatrixXd&, Index);
template MatrixXd deviator<3>(const MatrixXd&, Index);
template class CellField<2>;
template class CellField<3>;

}  // namespace clevis::stress
