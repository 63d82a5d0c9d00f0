#include "stress/field/point_history.h"

#include "elasticity/algebra/dense_product.h"
#include "stress/field/cell_field.h"

namespace clevis::stress {

using Eigen::Index;
using Eigen::MatrixXd;

template <int dim>
PointHistory point_history(const elasticity::DisplacementBasis<dim>& basis,
                           const part::Material& material, int subdivisions,
                           const std::vector<FieldPoint>& points,
                           const std::vector<int>& instants) {
  const auto lattice =
      elasticity::lattice<dim>(basis.discretization.shape, subdivisions);
  const CellField<dim> cell_field(basis.discretization, material, lattice);
  const Index n = lattice.cols();
  const auto count = static_cast<Index>(points.size());
  const auto columns = static_cast<Index>(instants.size());
  const Index rank = basis.columns.cols();
  const MatrixXd coefficients = basis.coefficients(Eigen::all, instants);
  PointHistory history{MatrixXd(count, columns),
                       MatrixXd(count * dim, columns)};
  int cell = -1;
  MatrixXd mises, moved;
  for (Index p = 0; p < count; ++p) {
    const FieldPoint& at = points[static_cast<std::size_t>(p)];
    if (at.cell != cell) {
      cell = at.cell;
      const auto c = static_cast<std::size_t>(cell);
      mises = von_mises_squared<dim>(
                  elasticity::product(cell_field.stress(c, basis.columns),
                                      coefficients),
                  n)
                  .sqrt();
      moved = cell_field.displacement(c, basis.columns);
    }
    history.von_mises.row(p) = mises.row(at.point);
    for (int d = 0; d < dim; ++d) {
      history.displacement.row(p + d * count) =
          moved.row(at.point).segment(d * rank, rank) * coefficients;
    }
  }
  return history;
}

template PointHistory point_history<2>(const elasticity::DisplacementBasis<2>&,
                                       const part::Material&, int,
                                       const std::vector<FieldPoint>&,
                                       const std::vector<int>&);
template PointHistory point_history<3>(const elasticity::DisplacementBasis<3>&,
                                       const part::Material&, int,
                                       const std::vector<FieldPoint>&,
                                       const std::vector<int>&);

}  // namespace clevis::stress
