#include "stress/field/cell_field.h"

#include <cmath>

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

template <int dim>
CellField<dim>::CellField(const elasticity::Discretization<dim>& discretization,
                          const part::Material& material,
                          const elasticity::ReferencePoints<dim>& points)
    : discretization_(discretization),
      lame_(elasticity::lame_constants<dim>(material)),
      places_(elasticity::displacement_places<dim>(
          discretization.shape, discretization.displacement_degree())),
      displacement_(discretization.shape, discretization.displacement_degree(),
                    points),
      geometry_(discretization.shape, discretization.mapping_degree(), points) {
  if (!discretization.is_revolved) return;
  constexpr double kBeside = 1e-6;
  elasticity::ReferencePoints<dim> beside = points;
  beside.template topRows<2>() =
      points.template topRows<2>().cwiseMax(kBeside).cwiseMin(1.0 - kBeside);
  displacement_beside_ = {discretization.shape,
                          discretization.displacement_degree(), beside};
  geometry_beside_ = {discretization.shape, discretization.mapping_degree(),
                      beside};
}

template <int dim>
MatrixXd CellField<dim>::stress(std::size_t cell,
                                const MatrixXd& columns) const {
  const Index n = displacement_.points();
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
  return geometry_.values(discretization_.cell_points[cell].transpose());
}

template <int dim>
MatrixXd CellField<dim>::displacement(std::size_t cell,
                                      const MatrixXd& columns) const {
  return displacement_.values(nodal_values(cell, columns));
}

template <int dim>
MatrixXd CellField<dim>::nodal_values(std::size_t cell,
                                      const MatrixXd& columns) const {
  const auto& nodes = discretization_.cell_nodes[cell];
  MatrixXd values(static_cast<Index>(nodes.size()), dim * columns.cols());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (int a = 0; a < dim; ++a) {
      values.row(places_[i]).segment(a * columns.cols(), columns.cols()) =
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
  // Of the result and not of the basis functions, which are many more.
  return elasticity::physical_slopes<dim>(
      at, (touches_axis ? displacement_beside_ : displacement_)
              .gradients(nodal_values(cell, columns)));
}

template ArrayXXd von_mises_squared<2>(const MatrixXd&, Index);
template ArrayXXd von_mises_squared<3>(const MatrixXd&, Index);
template MatrixXd deviator<2>(const MatrixXd&, Index);
template MatrixXd deviator<3>(const MatrixXd&, Index);
template class CellField<2>;
template class CellField<3>;

}  // namespace clevis::stress
