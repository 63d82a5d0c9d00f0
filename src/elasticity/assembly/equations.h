#pragma once

#include <vector>

#include <Eigen/Core>

#include "elasticity/algebra/matrix_rows.h"
#include "elasticity/assembly/stiffness.h"

namespace clevis::elasticity {

/// Which degrees of freedom are solved for.
struct EquationNumbers {
  std::vector<int> equation;  ///< per degree of freedom; -1: held at zero
  int count{};
};

/// Numbers the degrees of freedom in their order, without the held ones.
EquationNumbers number_equations(int dofs, const std::vector<int>& held);

/// Rows and columns of the stiffness matrix that have an equation.
template <int dim>
UpperTriangle free_equations(const StiffnessMatrix<dim>& stiffness,
                             const EquationNumbers& numbers);

/// The same without a copy.
/// @param stiffness, numbers  outlive it.
template <int dim>
MatrixRows free_rows(const StiffnessMatrix<dim>& stiffness,
                     const EquationNumbers& numbers);

/// Rows of degrees of freedom (dofs × columns) to rows of equations (count ×
/// columns), and back with zero where held; in the units of the argument.
Eigen::MatrixXd restrict_rows(const Eigen::MatrixXd& full,
                              const EquationNumbers& numbers);
Eigen::MatrixXd extend_rows(const Eigen::MatrixXd& reduced,
                            const EquationNumbers& numbers);

}  // namespace clevis::elasticity
