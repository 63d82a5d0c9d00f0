#pragma once

#include <string>
#include <vector>

#include "elasticity/assembly/foundation.h"
#include "elasticity/dealii_space/level_degrees.h"
#include "elasticity/fe_space/discretization.h"
#include "part/material.h"

namespace clevis::elasticity {

/// What a DealiiSolver is made of.
template <int dim>
struct DealiiTask {
  const Discretization<dim>& discretization;
  const part::Material& material;
  const FoundationStiffness<dim>& bed;
  const std::vector<int>& held;
  const std::string& place;
  bool is_shared;
  double most_factored = kMostFactored;  ///< equations of the coarsest level
};

/// One for each held degree of freedom of the discretisation, else zero.
template <int dim>
std::vector<char> held_marks(const DealiiTask<dim>& task) {
  std::vector<char> marks(static_cast<std::size_t>(task.discretization.dofs()));
  for (const int dof : task.held) marks[static_cast<std::size_t>(dof)] = 1;
  return marks;
}

/// Effort of a solve, largest over the columns.
struct DealiiReport {
  int iterations{};     ///< conjugate gradients, all sweeps
  double correction{};  ///< of the last sweep over the solution [1]
  int levels{};         ///< degrees of the multigrid
  double bytes_sent{};  ///< by all ranks in a product with K
};

}  // namespace clevis::elasticity
