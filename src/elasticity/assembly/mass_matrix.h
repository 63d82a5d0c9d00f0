#pragma once

#include <vector>

#include "elasticity/algebra/sparse_cholesky.h"
#include "elasticity/assembly/equations.h"
#include "elasticity/assembly/stiffness.h"
#include "elasticity/fe_space/discretization.h"

namespace clevis::elasticity {

/// Consistent mass ∫ ρ N_i N_j dV (times the thickness for dim = 2), the same
/// for every component of the displacement; on the stiffness' pattern.
struct MassMatrix {
  std::vector<int> row_start;  ///< nodes + 1
  std::vector<int> column;     ///< of the upper triangle
  std::vector<double> value;   ///< [kg]
};

/// Adds a cell's element matrix, of its nodes, to the upper triangle.
void add_element(const std::vector<int>& nodes, const Eigen::MatrixXd& element,
                 MassMatrix& matrix);

/// Mass matrix, nodes × nodes [kg].
/// @param pattern  of the same discretisation.
/// @param density  [kg/m³].
template <int dim>
MassMatrix assemble_mass(const Discretization<dim>& discretization,
                         const StiffnessMatrix<dim>& pattern, double density);

/// Rows and columns of the mass matrix that have an equation.
/// @param dim  components per node.
UpperTriangle free_equations(const MassMatrix& mass, int dim,
                             const EquationNumbers& numbers);

/// A + s B, s in the units of A over those of B.
/// @param b  its pattern is part of a's.
UpperTriangle weighted_sum(const UpperTriangle& a, double s,
                           const UpperTriangle& b);

}  // namespace clevis::elasticity
