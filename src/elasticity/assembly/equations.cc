#include "elasticity/assembly/equations.h"

#include <utility>

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

namespace {

/// Visits a row of equations in the blocks of its node.
/// @param dof  of the row.
/// @param put  (equation, value, whether it counts: neither held nor below the
///   diagonal).
template <int dim, typename Put>
void visit_row(const StiffnessMatrix<dim>& stiffness,
               const std::vector<int>& equation, std::size_t dof,
               const Put& put) {
  const std::size_t node = dof / dim;
  const auto a = static_cast<Index>(dof % dim);
  const int row = equation[dof];
  for (int k = stiffness.row_start[node]; k < stiffness.row_start[node + 1];
       ++k) {
    const auto at = static_cast<std::size_t>(k);
    const int* columns =
        &equation[dim * static_cast<std::size_t>(stiffness.column[at])];
    for (int b = 0; b < dim; ++b) {
      put(columns[b], stiffness.block[at](a, b), columns[b] >= row);
    }
  }
}

}  // namespace

template <int dim>
UpperTriangle free_equations(const StiffnessMatrix<dim>& stiffness,
                             const EquationNumbers& numbers) {
  UpperTriangle upper;
  upper.row_start.push_back(0);
  upper.column.resize(stiffness.column.size() * dim * dim);
  upper.value.resize(upper.column.size());
  std::size_t next = 0;
  for (std::size_t dof = 0; dof < numbers.equation.size(); ++dof) {
    if (numbers.equation[dof] < 0) continue;
    visit_row<dim>(stiffness, numbers.equation, dof,
                   [&](int column, double value, bool counts) {
                     // Written in any case, kept if it counts.
                     upper.column[next] = column;
                     upper.value[next] = value;
                     next += counts ? 1 : 0;
                   });
    upper.row_start.push_back(entry_number(next));
  }
  upper.column.resize(next);
  upper.value.resize(next);
  return upper;
}

template <int dim>
MatrixRows free_rows(const StiffnessMatrix<dim>& stiffness,
                     const EquationNumbers& numbers) {
  std::vector<std::size_t> dof_of;  // of each equation
  for (std::size_t dof = 0; dof < numbers.equation.size(); ++dof) {
    if (numbers.equation[dof] >= 0) dof_of.push_back(dof);
  }
  return {numbers.count, [&stiffness, &numbers, dof_of = std::move(dof_of)](
                             int row, MatrixRows::Room& room) {
            room.columns.clear();
            room.values.clear();
            visit_row<dim>(stiffness, numbers.equation,
                           dof_of[static_cast<std::size_t>(row)],
                           [&](int column, double value, bool counts) {
                             if (!counts) return;
                             room.columns.push_back(column);
                             room.values.push_back(value);
                           });
            return MatrixRows::Row{room.columns, room.values};
          }};
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

template MatrixRows free_rows<2>(const StiffnessMatrix<2>&,
                                 const EquationNumbers&);
template MatrixRows free_rows<3>(const StiffnessMatrix<3>&,
                                 const EquationNumbers&);
template UpperTriangle free_equations<2>(const StiffnessMatrix<2>&,
                                         const EquationNumbers&);
template UpperTriangle free_equations<3>(const StiffnessMatrix<3>&,
                                         const EquationNumbers&);

}  // namespace clevis::elasticity
