#include "elasticity/problem/nodal_field.h"

namespace clevis::elasticity {

using Eigen::Index;

template <int dim>
Eigen::VectorXd carried_over(const NodalField<dim>& field,
                             const Discretization<dim>& to) {
  using Values = Eigen::Matrix<double, dim, Eigen::Dynamic>;
  const Discretization<dim>& from = field.discretization;
  const auto table = tabulate_displacement<dim>(
      to.shape, from.displacement_degree(),
      displacement_support_points<dim>(to.shape, to.displacement_degree()));
  Eigen::VectorXd result(to.dofs());
  for (std::size_t c = 0; c < to.cell_nodes.size(); ++c) {
    Values values(dim, table.values.cols());
    for (Index i = 0; i < values.cols(); ++i) {
      values.col(i) = field.values.template segment<dim>(
          dim * from.cell_nodes[c][static_cast<std::size_t>(i)]);
    }
    const Values here = values * table.values.transpose();
    for (Index i = 0; i < here.cols(); ++i) {
      result.template segment<dim>(
          dim * to.cell_nodes[c][static_cast<std::size_t>(i)]) = here.col(i);
    }
  }
  return result;
}

template Eigen::VectorXd carried_over<2>(const NodalField<2>&,
                                         const Discretization<2>&);
template Eigen::VectorXd carried_over<3>(const NodalField<3>&,
                                         const Discretization<3>&);

}  // namespace clevis::elasticity
