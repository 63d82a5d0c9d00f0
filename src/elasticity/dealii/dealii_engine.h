#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/assembly/foundation.h"
#include "elasticity/fe_space/discretization.h"
#include "part/material.h"

namespace clevis::elasticity {

/// Effort of a solve, largest over the columns.
struct DealiiReport {
  int iterations{};     ///< conjugate gradients, all sweeps
  double correction{};  ///< of the last sweep over the solution [1]
  int levels{};         ///< degrees of the multigrid
};

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

/// The part of DealiiSolver, loads [N] and displacements [m], that is in the
/// library of deal.II and PETSc.
class DealiiEngine {
 public:
  virtual ~DealiiEngine() = default;
  virtual Eigen::MatrixXd solve(const Eigen::MatrixXd& loads) = 0;
  virtual Eigen::MatrixXd multiply_absolute_diagonal(
      const Eigen::MatrixXd& columns) const = 0;
  virtual const DealiiReport& report() const = 0;
};

/// The library's function that makes one, and its name.
template <int dim>
using DealiiEntry = std::unique_ptr<DealiiEngine>(const DealiiTask<dim>& task);
template <int dim>
inline constexpr const char* kDealiiEntry =
    dim == 2 ? "clevis_dealii_2" : "clevis_dealii_3";

}  // namespace clevis::elasticity
