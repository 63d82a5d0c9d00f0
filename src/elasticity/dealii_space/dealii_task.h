#pragma once

#include <string>
#include <vector>

#include "elasticity/assembly/foundation.h"
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
};

/// Effort of a solve, largest over the columns.
struct DealiiReport {
  int iterations{};     ///< conjugate gradients, all sweeps
  double correction{};  ///< of the last sweep over the solution [1]
  int levels{};         ///< degrees of the multigrid
};

}  // namespace clevis::elasticity
