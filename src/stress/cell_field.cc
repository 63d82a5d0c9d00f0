#include "stress/cell_field.h"

#include "elasticity/dense_product.h"

namespace clevis::stress {

using Eigen::Index;
using Eigen::MatrixXd;

template <int dim>
CellField<dim>::CellField(const elasticity::Discretization<dim>& discretization,
                          const part::Material& material,
                          const elasticity::ReferencePoints<dim>& points)
    : discretization_(discretization),
      lame_(elasticity::lame_constants<dim>(material)),
      displacement_(elasticity::tabulate_displacement<dim>(
          discretization.shape, discretization.displacement_degree(), points)),
      geometry_(elasticity::tabulate_geometry<dim>(
          discretization.shape, discretization.mapping_degree(), points)) {
  if (!discretization.is_revolved) return;
  constexpr double kBeside = 1e-6;
  elasticity::ReferencePoints<dim> beside = points;
  beside.template topRows<2>() =
      points.template topRows<2>().cwiseMax(kBeside).cwiseMin(1.0 - kBeside);
  displacement_beside_ = elasticity::tabulate_displacement<dim>(
      discretization.shape, discretization.displacement_degree(), beside);
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
  const auto physical = elasticity::physical_gradients(
      at, touches_axis ? displacement_beside_ : displacement_);
  const auto n = displacement_.values.rows();
  MatrixXd stacked(dim * n, displacement_.values.cols());
  for (int d = 0; d < dim; ++d) {
    stacked.middleRows(d * n, n) = physical[static_cast<std::size_t>(d)];
  }
  return elasticity::product(stacked, nodal_values(cell, columns));
}

template class CellField<2>;
template class CellField<3>;

}  // namespace clevis::stress
