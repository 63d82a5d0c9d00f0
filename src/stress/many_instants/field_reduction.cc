#include "stress/many_instants/field_reduction.h"

#include <utility>

#include "elasticity/algebra/dense_product.h"
#include "elasticity/algebra/principal_columns.h"
#include "stress/field/cell_field.h"

namespace clevis::stress {

using Eigen::Index;
using Eigen::MatrixXd;

template <int dim>
elasticity::DisplacementBasis<dim> reduced_field(
    const elasticity::DisplacementBasis<dim>& basis,
    const part::Material& material) {
  constexpr double kAdmitted = 1e-4;
  const auto& discretization = basis.discretization;
  const auto corners = elasticity::lattice<dim>(discretization.shape, 1);
  const CellField<dim> cell_field(discretization, material, corners);
  const Index rows = kStressComponents<dim> * corners.cols();
  MatrixXd stress(rows * discretization.cells(), basis.columns.cols());
  for (Index c = 0; c < discretization.cells(); ++c) {
    stress.middleRows(rows * c, rows) =
        cell_field.stress(static_cast<std::size_t>(c), basis.columns);
  }
  auto principal = elasticity::principal_columns(
      elasticity::transposed_product(stress, stress), basis.coefficients,
      kAdmitted, basis.columns.cols());
  elasticity::DisplacementBasis<dim> reduced;
  reduced.discretization = discretization;
  reduced.columns = elasticity::product(basis.columns, principal.combinations);
  reduced.coefficients = std::move(principal.coefficients);
  return reduced;
}

template elasticity::DisplacementBasis<2> reduced_field<2>(
    const elasticity::DisplacementBasis<2>&, const part::Material&);
template elasticity::DisplacementBasis<3> reduced_field<3>(
    const elasticity::DisplacementBasis<3>&, const part::Material&);

}  // namespace clevis::stress
