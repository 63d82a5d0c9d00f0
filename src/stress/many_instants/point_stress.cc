#include "stress/many_instants/point_stress.h"

#include <algorithm>

#include "elasticity/algebra/dense_product.h"
#include "stress/field/cell_field.h"

namespace clevis::stress {

using Eigen::Index;
using Eigen::MatrixXd;

template <int dim>
PointStress<dim>::PointStress(
    const elasticity::Discretization<dim>& discretization,
    const part::Material& material, int subdivisions,
    const std::vector<FieldPoint>& points, const MatrixXd& columns)
    : points_(static_cast<Index>(points.size())),
      deviator_(kDeviatorComponents<dim> * points_, columns.cols()) {
  const auto lattice =
      elasticity::lattice<dim>(discretization.shape, subdivisions);
  const CellField<dim> cell_field(discretization, material, lattice);
  int cell = -1;
  MatrixXd of_cell;
  for (Index p = 0; p < points_; ++p) {
    const FieldPoint& at = points[static_cast<std::size_t>(p)];
    if (at.cell != cell) {
      cell = at.cell;
      of_cell = deviator<dim>(
          cell_field.stress(static_cast<std::size_t>(cell), columns),
          lattice.cols());
    }
    for (Index k = 0; k < kDeviatorComponents<dim>; ++k) {
      deviator_.row(k * points_ + p) =
          of_cell.row(k * lattice.cols() + at.point);
    }
  }
}

template <int dim>
MatrixXd PointStress<dim>::von_mises(const MatrixXd& coefficients) const {
  constexpr Index kBlock = 256;  // instants, so that few components are held
  MatrixXd result(points_, coefficients.cols());
  for (Index begin = 0; begin < coefficients.cols(); begin += kBlock) {
    const Index count = std::min(kBlock, coefficients.cols() - begin);
    const MatrixXd here =
        elasticity::product(deviator_, coefficients.middleCols(begin, count));
    auto to = result.middleCols(begin, count).array();
    to = here.topRows(points_).array().square();
    for (Index k = 1; k < kDeviatorComponents<dim>; ++k) {
      to += here.middleRows(k * points_, points_).array().square();
    }
    to = to.sqrt().eval();
  }
  return result;
}

template class PointStress<2>;
template class PointStress<3>;

}  // namespace clevis::stress
