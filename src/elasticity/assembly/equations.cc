#include "elasticity/assembly/equations.h"

namespace clevis::elasticity {

using Eigen::Index;
using Eigen::MatrixXd;

EquationNumbers number_equations(int dofs, const std::vector<int>& held) {
  EquationNumbers numbers;
  numbers.equation.assign(static_cast<std::size_t>(dofs), 0);
  for (int dof : held) numbers.equation[static_cast<std::size_t>(dof)] = -1;
  for (int& e : numbers.equation) {
    if (e == 0) e = numbers.count++;
  }
  return numbers;
}

template <int dim>
UpperTriangle free_equations(const StiffnessMatrix<dim>& stiffness,
                             const EquationNumbers& numbers) {
  const std::vector<int>& equation = numbers.equation;
  UpperTriangle upper;
  upper.row_start.push_back(0);
  upper.column.resize(stiffness.column.size() * dim * dim);
  upper.value.resize(upper.column.size());
  std::size_t next = 0;
  for (int node = 0; node < stiffness.nodes(); ++node) {
    const auto n = static_cast<std::size_t>(node);
    for (int a = 0; a < dim; ++a) {
      const int row = equation[dim * n + static_cast<std::size_t>(a)];
      if (row < 0) continue;
      for (int k = stiffness.row_start[n]; k < stiffness.row_start[n + 1];
           ++k) {
        const auto at = static_cast<std::size_t>(k);
        const int* columns =
            &equation[dim * static_cast<std::size_t>(stiffness.column[at])];
        for (int b = 0; b < dim; ++b) {
          // Written in any case, kept unless held or below the diagonal.
          upper.column[next] = columns[b];
          upper.value[next] = stiffness.block[at](a, b);
          next += columns[b] >= row ? 1 : 0;
        }
      }
      upper.row_start.push_back(entry_number(next));
    }
  }
  upper.column.resize(next);
  upper.value.resize(next);
  return upper;
}

MatrixXd restrict_rows(const MatrixXd& full, const EquationNumbers& numbers) {
  MatrixXd result(numbers.count, full.cols());
  for (std::size_t dof = 0; dof < numbers.equation.size(); ++dof) {
    const int row = numbers.equation[dof];
    if (row >= 0) result.row(row) = full.row(static_cast<Index>(dof));
  }
  return result;
}

MatrixXd extend_rows(const MatrixXd& reduced, const EquationNumbers& numbers) {
  MatrixXd result = MatrixXd::Zero(static_cast<Index>(numbers.equation.size()),
                                   reduced.cols());
  for (std::size_t dof = 0; dof < numbers.equation.size(); ++dof) {
    const int row = numbers.equation[dof];
    if (row >= 0) result.row(static_cast<Index>(dof)) = reduced.row(row);
  }
  return result;
}

template UpperTriangle free_equations<2>(const StiffnessMatrix<2>&,
                                         const EquationNumbers&);
template UpperTriangle free_equations<3>(const StiffnessMatrix<3>&,
                                         const EquationNumbers&);

}  // namespace clevis::elasticity
