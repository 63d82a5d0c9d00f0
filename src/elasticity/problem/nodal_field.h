#pragma once

#include <Eigen/Core>

#include "elasticity/fe_space/discretization.h"

namespace clevis::elasticity {

/// A displacement on its discretisation.
template <int dim>
struct NodalField {
  Discretization<dim> discretization;
  Eigen::VectorXd values;  ///< dofs [m]
};

/// The field at the nodes of another degree on the same cells.
template <int dim>
Eigen::VectorXd carried_over(const NodalField<dim>& field,
                             const Discretization<dim>& to);

}  // namespace clevis::elasticity
